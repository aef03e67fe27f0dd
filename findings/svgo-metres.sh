#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SVGO 4.1.0 on a sheet A2 whose user unit is the metre (viewBox 0 0 0.594 0.42): it rounds to three decimals whatever the viewBox,
# so lines of 0.35 mm get the width 0, and a circle of 0.4 mm vanishes: nothing is left to see. The same sheet in millimetres stays.
# Its page names floatPrecision 3, not that it is absolute. Believed: an optimizer keeps what is seen.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svgo@4.1.0 @resvg/resvg-js@2.6.2
cat >sheet.cjs <<'JS'
const { optimize } = require('svgo');
const { Resvg } = require('@resvg/resvg-js');
const black = svg => {
  const pixels = new Resvg(svg, { fitTo: { mode: 'width', value: 5940 }, background: '#fff' }).render().pixels;
  let count = 0;
  for (let i = 0; i < pixels.length; i += 4) count += pixels[i] < 128;
  return count / 100;  // pixels of 0.1 mm
};
for (const [name, unit] of [['millimetres', 1], ['metres', 0.001]]) {
  const n = millimetres => Number((millimetres * unit).toPrecision(6));
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="594mm" height="420mm" viewBox="0 0 ${n(594)} ${n(420)}">
<g stroke="#000" fill="none" stroke-width="${n(0.35)}"><path d="M${n(100.25)} ${n(100)}H${n(300)}V${n(200.25)}H${n(100.25)}Z"/>
<circle cx="${n(50)}" cy="${n(50)}" r="${n(0.4)}"/></g></svg>`;
  const { data } = optimize(svg);
  console.log(`${name}: ${Math.round(black(svg))} mm2 black, ${Math.round(black(data))} afterwards; ` +
              `circle ${data.includes('<circle') ? 'kept' : 'gone'}`);
}
JS
node sheet.cjs >seen
expect_in seen <<'END'
millimetres: 211 mm2 black, 211 afterwards; circle kept
metres: 211 mm2 black, 0 afterwards; circle gone
END
