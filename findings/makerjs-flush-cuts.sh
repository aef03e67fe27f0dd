#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# makerjs 0.19.2, which makes outlines for laser cutters: a notch flush with the side of a plate (combineSubtraction) leaves the side whole, and the
# notch as an open chain behind it, so that it stays closed; of a step cut from a corner and of a whole end it is the same. A notch
# that begins 1 mm before the side is right. Unions and intersections with such sides are right. Nothing is said. Believed: one closed outline.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages makerjs@0.19.2
cat >cuts.cjs <<'JS'
const { models: { Rectangle }, model } = require("makerjs");
const at = (x, y, width, height) => model.move(new Rectangle(width, height), [x, y]);
const plate = () => at(0, 0, 20, 10);
const chains = (shape) => model.findChains(shape).map((chain) => `${chain.endless ? "closed" : "open"} ${chain.pathLength}`).join(", ");
const notches = { "inside": [at(8, 3, 4, 4), 76], "1 mm over the side": [at(8, 7, 4, 4), 66], "flush with the side": [at(8, 6, 4, 4), 68], "in a corner": [at(16, 6, 4, 4), 60], "a whole end": [at(16, 0, 4, 10), 52] };
for (const [where, [notch, length]] of Object.entries(notches)) console.log(`cut ${where}: ${chains(model.combineSubtraction(plate(), notch))}; right would be ${length} in all`);
console.log("tab flush with the side, added: " + chains(model.combineUnion(plate(), at(8, 10, 4, 4))) + "; right would be 68");
JS
node cuts.cjs >seen
expect_in seen <<'END'
cut inside: closed 60, closed 16; right would be 76 in all
cut 1 mm over the side: closed 66; right would be 66 in all
cut flush with the side: closed 60, open 12; right would be 68 in all
cut in a corner: closed 60, open 8; right would be 60 in all
cut a whole end: closed 60; right would be 52 in all
tab flush with the side, added: closed 68; right would be 68
END
