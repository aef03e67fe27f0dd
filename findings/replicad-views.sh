#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# replicad 1.1.0 (on Open CASCADE for the browser): drawProjection(body, "top") draws the body as seen from below, "bottom" from above, "left" from the
# right and "right" from the left; front and back are as named. Believed: each view is the one from the side that it is named after, with z
# up, as its own page says: a body with a pad of another width on each side shows which is in front.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages replicad@1.1.0 replicad-opencascadejs@1.1.0
cat >views.mjs <<'JS'
import { readFileSync } from 'fs';
import { createRequire } from 'module';
import { drawProjection, makeBaseBox, setOC } from 'replicad';

globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = process.cwd();
const { default: start } = await import('replicad-opencascadejs');
setOC(await start({ wasmBinary: readFileSync('node_modules/replicad-opencascadejs/dist/replicad_single.wasm') }));

// A box of 40 x 40 x 40 around the origin, and on each side a pad, in whose middle lies the middle of the side.
const pads = { left: [-21, 0, 0, 1], right: [21, 0, 0, 2], front: [0, -21, 0, 3], back: [0, 21, 0, 4], bottom: [0, 0, -21, 5], top: [0, 0, 21, 6] };
let body = makeBaseBox(40, 40, 40).translate([0, 0, -20]);
for (const [x, y, z, half] of Object.values(pads))
  body = body.fuse(makeBaseBox(x ? 4 : 2 * half, y ? 4 : 2 * half, z ? 4 : 2 * half).translate([x, y, z - (z ? 2 : half)]));
for (const view of Object.keys(pads)) {
  const visible = drawProjection(body, view).visible.toSVG();
  const seen = Object.keys(pads).filter((side) => {
    const half = pads[side][3];
    // The pad in front is a square around the middle of the view; those at the sides stand out by 3.
    return new RegExp(`-${half} -${half} L ${half} -${half}|${half} -${half} L -${half} -${half}`).test(visible);
  });
  console.log(`${view}: from the ${seen}`);
}
JS
node views.mjs >seen
expect_in seen <<'END'
left: from the right
right: from the left
front: from the front
back: from the back
bottom: from the top
top: from the bottom
END
