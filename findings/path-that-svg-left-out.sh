#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# path-that-svg 1.2.4 (npm) writes NaN into paths of shapes whose attributes are left out where they are 0: of <circle r="5"/> and <line x2="10"/>,
# which it replaces, nothing can be drawn any more, and readers stop at such a path (SVG 1.1, 8.3.9). Lengths in millimetres become NaN, too.
# Nothing is said. What has all its attributes as plain numbers, and rectangles without x and y, are right.
# Believed: as SVG 1.1, 9.2 to 9.5 has them: "If the attribute is not specified, the effect is as if a value of '0' were specified".
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages path-that-svg@1.2.4
cat >paths.js <<'JS'
const { pathThatSvg } = require("path-that-svg");
(async () => {
  for (const shape of ['<circle cx="0" cy="0" r="5"/>', '<circle r="5"/>', '<ellipse cx="9" rx="5" ry="3"/>', '<line x1="0" y1="0" x2="10" y2="0"/>', '<line x2="10"/>',
                       '<rect width="10" height="20"/>', '<rect width="10mm" height="20mm"/>'])
    console.log(`${shape}: ${(await pathThatSvg(`<svg xmlns="http://www.w3.org/2000/svg">${shape}</svg>`)).match(/d="(.*?)"/)[1]}`);
})();
JS
node paths.js >seen
expect_in seen <<'END'
<circle cx="0" cy="0" r="5"/>: M5 0 A5 5 0 0 1 0 5 A5 5 0 0 1 -5 0 A5 5 0 0 1 5 0 z
<circle r="5"/>: MNaN NaN A5 5 0 0 1 NaN NaN A5 5 0 0 1 NaN NaN A5 5 0 0 1 NaN NaN z
<ellipse cx="9" rx="5" ry="3"/>: M14 NaN A5 3 0 0 1 9 NaN A5 3 0 0 1 4 NaN A5 3 0 0 1 14 NaN z
<line x1="0" y1="0" x2="10" y2="0"/>: M0 0 L10 0
<line x2="10"/>: MNaN NaN L10 NaN
<rect width="10" height="20"/>: M0 0 H10 V20 H0 V0 z
<rect width="10mm" height="20mm"/>: M0 0 HNaN VNaN H0 V0 z
END
