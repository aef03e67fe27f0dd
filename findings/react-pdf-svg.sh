#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @react-pdf/renderer 4.9.0 (npm) draws what visibility or display hides in its Svg, begins all dashes at their beginning (strokeDashoffset), so
# that lines that meet in a dash by the SVG do not, draws a line dashed that says "none" in a dashed group, and takes millimetres for user
# units. Nothing is said. Transforms, arcs, clips, holes and the dashes themselves are right. Believed: as librsvg 2.54 does with the same SVG.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3
npm_packages @react-pdf/renderer@4.9.0 react@19.1.0
cat >draw.mjs <<'JS'
import fs from "fs";
import React from "react";
import * as pdf from "@react-pdf/renderer";
const e = React.createElement, line = { x1: 0, y1: 50, x2: 100, y2: 50, stroke: "#000", strokeWidth: 2 };
const cases = {
  turned: e(pdf.Rect, { x: 20, y: 0, width: 30, height: 40, fill: "#000", transform: "translate(10 0) rotate(30)" }),
  arc: e(pdf.Path, { d: "M10 50A30 15 30 0 1 60 50", fill: "none", stroke: "#000", strokeWidth: 2 }),
  dashed: e(pdf.Line, { ...line, strokeDasharray: "20 20" }),
  "dashed from 20 on": e(pdf.Line, { ...line, strokeDasharray: "20 20", strokeDashoffset: 20 }),
  "not dashed in a dashed group": e(pdf.G, { strokeDasharray: "20 20" }, e(pdf.Line, { ...line, strokeDasharray: "none" })),
  hidden: e(pdf.Line, { ...line, visibility: "hidden" }),
  "not displayed": e(pdf.Line, { ...line, display: "none" }),
  millimetres: e(pdf.Rect, { width: "20mm", height: "10mm", fill: "#000" }),
};
const tag = (text) => text.replace(/[A-Z]/g, (letter) => "-" + letter.toLowerCase());
const svg = ({ type, props: { children, ...rest } }) =>
  `<${type.toLowerCase()} ${Object.entries(rest).map(([name, value]) => `${tag(name)}="${value}"`).join(" ")}>${children ? svg(children) : ""}</${type.toLowerCase()}>`;
for (const [number, [name, shape]] of Object.entries(cases).entries()) {
  fs.writeFileSync(`${number}.name`, name);
  fs.writeFileSync(`${number}.svg`, `<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100" viewBox="0 0 100 100">${svg(shape)}</svg>`);
  const page = e(pdf.Page, { size: [100, 100] }, e(pdf.Svg, { width: 100, height: 100, viewBox: "0 0 100 100" }, shape));
  const stream = await pdf.pdf(e(pdf.Document, {}, page)).toBuffer(), parts = [];
  for await (const part of stream) parts.push(part);
  fs.writeFileSync(`${number}-react.pdf`, Buffer.concat(parts));
}
JS
cat >ink.py <<'PY'
import sys
data = open(sys.argv[1], "rb").read()
width, height = map(int, data.split(None, 3)[1:3])
black = [i % width for i, value in enumerate(data[len(data) - width * height:]) if value < 128]
print(f"x {round(min(black) * 100 / width)} to {round(max(black) * 100 / width)}, {len(black) / width / height:.1%} black" if black else "nothing")
PY
node draw.mjs 2>messages || { tail -n 3 messages; exit 1; }
for name in *.name; do
  number=${name%.name}
  rsvg-convert -f pdf -b white -o "$number-librsvg.pdf" "$number.svg"
  for program in react librsvg; do pdftoppm -scale-to 400 -gray -singlefile "$number-$program.pdf" "$number-$program"; done
  echo "$(cat "$name"): $(python3 ink.py "$number-react.pgm"); librsvg $(python3 ink.py "$number-librsvg.pgm")"
done >seen
expect_in seen <<'END'
turned: x 7 to 53, 12.0% black; librsvg x 7 to 53, 12.0% black
arc: x 4 to 60, 1.6% black; librsvg x 4 to 60, 1.6% black
dashed: x 0 to 100, 1.2% black; librsvg x 0 to 100, 1.2% black
dashed from 20 on: x 0 to 100, 1.2% black; librsvg x 20 to 80, 0.8% black
not dashed in a dashed group: x 0 to 100, 1.2% black; librsvg x 0 to 100, 2.0% black
hidden: x 0 to 100, 2.0% black; librsvg nothing
not displayed: x 0 to 100, 2.0% black; librsvg nothing
millimetres: x 0 to 20, 2.0% black; librsvg x 0 to 75, 28.5% black
END
