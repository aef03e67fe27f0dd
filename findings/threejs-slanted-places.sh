#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0: ThreeMFLoader and ColladaLoader take each place apart into a move, a turn and three scales, which none has that slants
# the body, such as a scale outside of a turn (as modellers write COLLADA) or a shear of 3MF: a box of 1000 mm3 sheared by its own
# height, whose volume stays, comes with 1407, in another box; the element "skew" is ignored. Nothing is said. Believed: corners are moved
# by the matrix, as both formats have it.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0 jsdom@29.1.1
cat >read.mjs <<'JS'
import { JSDOM } from 'jsdom';
import { Box3, Vector3 } from 'three';
import { ThreeMFLoader } from 'three/addons/loaders/3MFLoader.js';
import { ColladaLoader } from 'three/addons/loaders/ColladaLoader.js';
import { strToU8, zipSync } from 'three/addons/libs/fflate.module.js';

const { window } = new JSDOM();
globalThis.DOMParser = window.DOMParser;
globalThis.document = window.document;

const corners = [...Array(8).keys()].map((i) => [10 * (i & 1), 10 * (i >> 1 & 1), 10 * (i >> 2)]);
const facets = '0 2 3,0 3 1,4 5 7,4 7 6,0 1 5,0 5 4,2 6 7,2 7 3,0 4 6,0 6 2,1 3 7,1 7 5'.split(',').map((facet) => facet.split(' '));

function measure(what, body) {
  body.updateMatrixWorld(true);
  let volume = 0;
  body.traverse((mesh) => {
    if (!mesh.isMesh) return;
    const at = (mesh.geometry.index ? mesh.geometry.toNonIndexed() : mesh.geometry).attributes.position;
    for (let i = 0; i < at.count; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => new Vector3().fromBufferAttribute(at, i + k).applyMatrix4(mesh.matrixWorld));
      volume += a.dot(b.cross(c)) / 6;
    }
  });
  const { min, max } = new Box3().setFromObject(body);
  process.stdout.write(`${what}: ${['x', 'y', 'z'].map((axis) => `${min[axis].toFixed(1)}..${max[axis].toFixed(1)}`).join(' ')}, volume ${volume.toFixed(0)}\n`);
}

function collada(what, place) {
  const source = `<source id="p"><float_array id="a" count="24">${corners.flat().join(' ')}</float_array><technique_common><accessor source="#a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>`;
  const mesh = `<mesh>${source}<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>${facets.flat().join(' ')}</p></triangles></mesh>`;
  const text = `<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit name="m" meter="1"/><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g">${mesh}</geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node id="n">${place}<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>`;
  measure(`COLLADA, ${what}`, new ColladaLoader().parse(text).scene);
}

function threemf(what, transform) {
  const vertices = corners.map(([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`).join('');
  const triangles = facets.map(([a, b, c]) => `<triangle v1="${a}" v2="${b}" v3="${c}"/>`).join('');
  const files = {
    '[Content_Types].xml': '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>',
    '_rels/.rels': '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>',
    '3D/3dmodel.model': `<?xml version="1.0"?><model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model"><mesh><vertices>${vertices}</vertices><triangles>${triangles}</triangles></mesh></object></resources><build><item objectid="1" transform="${transform}"/></build></model>`,
  };
  measure(`3MF, ${what}`, new ThreeMFLoader().parse(zipSync(Object.fromEntries(Object.entries(files).map(([name, text]) => [name, strToU8(text)]))).buffer));
}

collada('moved and turned', '<translate>100 0 0</translate><rotate>0 0 1 90</rotate>');
collada('twice as long, then turned by 45 degrees', '<rotate>0 0 1 45</rotate><scale>2 1 1</scale>');
collada('turned by 45 degrees, then twice as long', '<scale>2 1 1</scale><rotate>0 0 1 45</rotate>');
collada('sheared by a matrix', '<matrix>1 1 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>');
collada('sheared by skew', '<skew>45 0 1 0 1 0 0</skew>');
threemf('moved', '1 0 0 0 1 0 0 0 1 100 0 0');
threemf('sheared', '1 0 0 1 1 0 0 0 1 0 0 0');
JS
node read.mjs | grep -v '^THREE' >seen
expect_in seen <<'END'
COLLADA, moved and turned: 90.0..100.0 0.0..10.0 0.0..10.0, volume 1000
COLLADA, twice as long, then turned by 45 degrees: -7.1..14.1 0.0..21.2 0.0..10.0, volume 2000
COLLADA, turned by 45 degrees, then twice as long: -10.6..11.6 0.0..22.2 0.0..10.0, volume 2460
COLLADA, sheared by a matrix: 0.0..14.3 -3.5..13.2 0.0..10.0, volume 1407
COLLADA, sheared by skew: 0.0..10.0 0.0..10.0 0.0..10.0, volume 1000
3MF, moved: 100.0..110.0 0.0..10.0 0.0..10.0, volume 1000
3MF, sheared: 0.0..14.3 -3.5..13.2 0.0..10.0, volume 1407
END
