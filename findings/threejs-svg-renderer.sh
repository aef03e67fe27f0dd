#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three.js 0.187.0 draws into SVG (SVGRenderer) no mirrored mesh at all, closed loops without their last side, one of several instances, elsewhere, lines
# of layers that the camera does not show, and lines beyond their draw range; dashes begin anew on each side and stay as long whatever the zoom; a square
# of 10 is up to 11.7 wide, and a line in front of a plate is hidden if its far end lies behind it. Nothing is said. Plain lines, indexed ones and
# groups that are not visible are right. Believed: what its other renderers draw, as vectors.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0 jsdom@29.1.1
cat >draw.mjs <<'JS'
import { JSDOM } from 'jsdom';
import * as T from 'three';
import { SVGRenderer } from 'three/addons/renderers/SVGRenderer.js';
globalThis.document = new JSDOM('').window.document;
const line = (Kind, points, material = new T.LineBasicMaterial()) => new Kind(new T.BufferGeometry().setFromPoints(points.map((p) => new T.Vector3(...p))), material);
const square = () => new T.Mesh(new T.PlaneGeometry(10, 10), new T.MeshBasicMaterial());
const corner = [[0, 0, 0], [20, 0, 0], [20, 20, 0]];
const draw = (name, things, zoom = 1) => {
  const scene = new T.Scene().add(...things), camera = new T.OrthographicCamera(-50, 50, 50, -50, 1, 1000), renderer = new SVGRenderer();
  camera.position.z = 100;
  camera.zoom = zoom;
  camera.updateProjectionMatrix();
  renderer.setSize(100, 100);
  renderer.setPrecision(1);
  renderer.render(scene, camera);
  const paths = [...renderer.domElement.childNodes].map((node) => {
    const dashes = /dasharray:([\d,]*)/.exec(node.getAttribute('style'));
    return node.getAttribute('d').replaceAll('.0', '') + (dashes ? ` dashed ${dashes[1]}` : '');
  });
  console.log(`${name}: ${paths.join(' then ') || 'nothing'}`);
};
const mirrored = square(), layer = line(T.Line, corner.slice(0, 2)), part = line(T.Line, corner), hidden = new T.Group();
const dashed = line(T.Line, corner, new T.LineDashedMaterial({ dashSize: 4, gapSize: 2 }));
const instances = new T.InstancedMesh(new T.PlaneGeometry(10, 10), new T.MeshBasicMaterial(), 2);
mirrored.scale.x = -1;
layer.layers.set(1);
part.geometry.setDrawRange(0, 2);
hidden.visible = false;
hidden.add(line(T.Line, corner));
[-20, 20].forEach((x, i) => instances.setMatrixAt(i, new T.Matrix4().makeTranslation(x, 0, 0)));
draw('square', [square()]);
draw('mirrored square', [mirrored]);
draw('instances at -20 and 20', [instances]);
draw('line', [line(T.Line, corner)]);
draw('loop', [line(T.LineLoop, corner)]);
draw('dashed', [dashed]);
draw('dashed, zoom 2', [dashed], 2);
draw('line of layer 1', [layer]);
draw('line up to its second point', [part]);
draw('line of an invisible group', [hidden]);
draw('line before the square, its end far behind', [square(), line(T.Line, [[-5, 0, 4], [45, 0, -12]])]);
draw('line before the square', [square(), line(T.Line, [[-5, 0, 4], [45, 0, 4]])]);
JS
node draw.mjs >seen
expect_in seen <<'END'
square: M-5.5,-5.5L-5.3,5.9L5.8,-5.4zM-5.9,5.4L5.5,5.5L5.3,-5.9z
mirrored square: nothing
instances at -20 and 20: M-5.5,-5.5L-5.3,5.9L5.8,-5.4zM-5.9,5.4L5.5,5.5L5.3,-5.9z
line: M0,0L20,0M20,0L20,-20
loop: M0,0L20,0M20,0L20,-20
dashed: M0,0L20,0M20,0L20,-20 dashed 4,2
dashed, zoom 2: M0,0L40,0M40,0L40,-40 dashed 4,2
line of layer 1: M0,0L20,0
line up to its second point: M0,0L20,0M20,0L20,-20
line of an invisible group: nothing
line before the square, its end far behind: M-5,0L45,0 then M-5.5,-5.5L-5.3,5.9L5.8,-5.4zM-5.9,5.4L5.5,5.5L5.3,-5.9z
line before the square: M-5.5,-5.5L-5.3,5.9L5.8,-5.4zM-5.9,5.4L5.5,5.5L5.3,-5.9z then M-5,0L45,0
END
