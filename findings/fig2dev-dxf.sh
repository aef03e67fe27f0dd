#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# fig2dev 3.2.8b (behind xfig) writes DXF mirrored from top to bottom, in inches that are 4.8 % too short where the figure is metric (100 mm
# become 3.75, not 3.937), without a unit, and leaves out arcs, the corners of rounded boxes and arrowheads. It ends with success. Its SVG,
# and its HP-GL (-L ibmgl), have sizes and sides right. Believed: as the SVG; the y of Fig points down, the y of DXF up.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages fig2dev=1:3.2.8b-3+deb12u2
npm_packages dxf-parser@1.1.2
figure() {  # NAME OBJECT
  { printf '#FIG 3.2\nLandscape\nCenter\nMetric\nA4\n100.00\nSingle\n-2\n1200 2\n'; cat; } >"$1.fig"
  fig2dev -L svg "$1.fig" "$1.svg"
  fig2dev -L dxf "$1.fig" "$1.dxf"
  fig2dev -L ibmgl "$1.fig" "$1.plt"
}
figure "line 100 mm long, 20 mm down" <<'FIG'
2 1 0 1 0 7 50 -1 -1 0.000 0 0 -1 0 0 2
	 0 0 4500 900
FIG
figure "half circle" <<'FIG'
5 1 0 1 0 7 50 -1 -1 0.000 0 0 0 0 2250.000 2250.000 1125 2250 2250 1125 3375 2250
FIG
figure "rounded box" <<'FIG'
2 4 0 1 0 7 50 -1 -1 0.000 0 0 7 0 0 5
	 4500 900 4500 0 0 0 0 900 4500 900
FIG
figure "line with arrowheads" <<'FIG'
2 1 0 1 0 7 50 -1 -1 0.000 0 0 -1 1 1 2
	1 1 1.00 60.00 120.00
	1 1 1.00 60.00 120.00
	 0 0 4500 0
FIG
cat >read.cjs <<'JS'
const { readFileSync } = require("fs");
const DxfParser = require("dxf-parser").default ?? require("dxf-parser");
for (const name of process.argv.slice(2)) {
  const { header, entities } = new DxfParser().parseSync(readFileSync(name + ".dxf", "utf8"));
  const said = entities.map(({ type, vertices }) => `${type} ${vertices.map(({ x, y }) => `(${x}, ${y})`).join(" ")}`);
  console.log(`${name}: DXF, unit ${header?.$INSUNITS ?? "unsaid"}: ${said.join(", ") || "nothing"}`);
  const svg = readFileSync(name + ".svg", "utf8");
  const [, width, box] = svg.match(/width="(\d+)pt".*\s+viewBox="[-\d]+ [-\d]+ (\d+)/);
  const mm = (value) => Math.round(value * width / box * 25.4 / 72);
  console.log(`${name}: SVG, ${mm(box) - mm(24)} mm wide: ${svg.match(/<(polyline|polygon|path d|rect)[ =][^>]*?(points|stroke|rx)="[^"]*"/g).map((it) => it.replace(/\s+(stroke=.*)?/g, " ").trim()).join(", ")}`);
}
JS
for name in *.fig; do node read.cjs "${name%.fig}"; done >seen
grep -h '^IP\|^SC\|^PA0.0000,0.0000' line\ 100*.plt >>seen
expect_in seen <<'END'
half circle: DXF, unit unsaid: nothing
half circle: SVG, 49 mm wide: <path d="M 1125,2250 A 1125 1125 0 0 1 3375 2250"
line 100 mm long, 20 mm down: DXF, unit unsaid: POLYLINE (0, 0) (3.75, 0.75)
line 100 mm long, 20 mm down: SVG, 100 mm wide: <polyline points=" 0,0 4500,900"
line with arrowheads: DXF, unit unsaid: POLYLINE (0, 0) (3.75, 0)
line with arrowheads: SVG, 100 mm wide: <polyline points=" 0,0 4500,0", <polygon points=" 4364,30 4484,0 4364,-30 4364,30", <polygon points=" 136,-30 16,0 136,30 136,-30"
rounded box: DXF, unit unsaid: LINE (0, 0.6625) (0, 0.0875), LINE (3.75, 0.6625) (3.75, 0.0875), LINE (0.0875, 0.75) (3.6625, 0.75), LINE (0.0875, 0) (3.6625, 0)
rounded box: SVG, 100 mm wide: <rect x="0" y="0" width="4500" height="900" rx="105"
IP0,8396,11881,0;
SC-3.8787,7.2602,-3.7382,4.1331;
PA0.0000,0.0000;PM;PD3.7500,0.7500;
END
