#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# pdfkit 0.20.2 and pdf-lib 1.17.1 draw the quadratic curves of paths (Q and T of SVG, quadraticCurveTo) by PDF's operator v, which is a
# cubic curve whose first control point is its beginning (ISO 32000-1, 8.5.2.2): a symmetric arch 10 high is 8.9 high and leans. Cubic
# curves are right, and svg-to-pdfkit 0.1.8 draws both right on pdfkit. Both leave arcs with a radius of 0 out, which are lines (SVG 1.1,
# F.6.2). Nothing is said. Believed: the same curves.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages pdfkit@0.20.2 pdf-lib@1.17.1 svg-to-pdfkit@0.1.8
cat >curves.cjs <<'JS'
const { inflateSync } = require("zlib");
const PDFDocument = require("pdfkit"), SVGtoPDF = require("svg-to-pdfkit"), { PDFDocument: Other } = require("pdf-lib");

// The highest point of the curves and lines of a page's content, in the space of the path: found from 1000 points of each.
function highest(content) {
  let operands = [], at = [0, 0], top = [0, -Infinity], drawn = "";
  const see = (points) => {
    for (let i = 0; i <= 1000; ++i) {
      let rest = points, t = i / 1000;
      while (rest.length > 1) rest = rest.slice(1).map((p, k) => [0, 1].map((axis) => (1 - t) * rest[k][axis] + t * p[axis]));
      if (rest[0][1] > top[1] + 1e-9) top = rest[0];
    }
    at = points[points.length - 1];
  };
  for (const token of content.split(/\s+/)) {
    if (token !== "" && !isNaN(token)) { operands.push(Number(token)); continue; }
    const pairs = operands.length % 2 ? [] : operands.flatMap((x, i) => (i % 2 ? [] : [[x, operands[i + 1]]]));
    if (token === "m") at = pairs[0];
    if (token === "v") see([at, at, ...pairs]);
    if (token === "c" || token === "l") see([at, ...pairs]);
    if (token === "n") top = [0, -Infinity], drawn = "";  // what clips
    if ("vcl".includes(token)) drawn += token;
    operands = [];
  }
  return drawn ? `operators ${drawn}, highest at ${top.map((value) => +value.toFixed(2) + 0).join(" ")}` : "nothing drawn";
}
const made = (how) => new Promise((done) => {
  const document = new PDFDocument({ compress: false, margin: 0 }), parts = [];
  document.on("data", (part) => parts.push(part)).on("end", () => done(highest(Buffer.concat(parts).toString("latin1").match(/stream\n([^]*?)endstream/)[1])));
  how(document);
  document.end();
});
(async () => {
  for (const [path, right] of [["M0 0C6 13 14 13 20 0", "9.75 at 10"], ["M0 0Q10 20 20 0", "10 at 10"], ["M0 0Q10 -20 20 0T40 0", "10 at 30"], ["M0 0A0 5 0 0 1 20 10", "10 at 20, a line"]]) {
    console.log(`${path}: right would be ${right}`);
    console.log(`  pdfkit: ${await made((page) => page.path(path).stroke())}`);
    console.log(`  svg-to-pdfkit: ${await made((page) => SVGtoPDF(page, `<svg xmlns="http://www.w3.org/2000/svg" width="99" height="99"><path d="${path}" fill="none" stroke="#000"/></svg>`, 0, 0))}`);
    const other = await Other.create();
    other.addPage().drawSvgPath(path, { x: 0, y: 0, borderWidth: 1 });
    const bytes = Buffer.from(await other.save({ useObjectStreams: false })), start = bytes.indexOf("stream\n") + 7;
    console.log(`  pdf-lib: ${highest(inflateSync(bytes.subarray(start, bytes.indexOf("\nendstream", start))).toString())}`);
  }
})();
JS
node curves.cjs >seen
expect_in seen <<'END'
M0 0C6 13 14 13 20 0: right would be 9.75 at 10
  pdfkit: operators c, highest at 10 9.75
  svg-to-pdfkit: operators c, highest at 10 9.75
  pdf-lib: operators c, highest at 10 9.75
M0 0Q10 20 20 0: right would be 10 at 10
  pdfkit: operators v, highest at 10.38 8.89
  svg-to-pdfkit: operators c, highest at 10 10
  pdf-lib: operators v, highest at 10.38 8.89
M0 0Q10 -20 20 0T40 0: right would be 10 at 30
  pdfkit: operators vv, highest at 30.38 8.89
  svg-to-pdfkit: operators cc, highest at 30 10
  pdf-lib: operators vv, highest at 30.38 8.89
M0 0A0 5 0 0 1 20 10: right would be 10 at 20, a line
  pdfkit: nothing drawn
  svg-to-pdfkit: operators l, highest at 20 10
  pdf-lib: nothing drawn
END
