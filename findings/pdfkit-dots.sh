#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# pdfkit 0.20.2 refuses dash patterns with a 0, such as dots with round caps and chain lines with dots, though PDF allows all but negative
# lengths and zeros alone (ISO 32000-1, 8.4.3.6): so svg-to-pdfkit 0.1.8 makes no PDF of an SVG that has one such line, which is valid, too
# (SVG 1.1, 11.4). pdf-lib 1.17.1 writes such lines. Believed: lines of dots.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages pdfkit@0.20.2 svg-to-pdfkit@0.1.8 pdf-lib@1.17.1
cat >dots.cjs <<'JS'
const { inflateSync } = require("zlib");
const PDFDocument = require("pdfkit"), SVGtoPDF = require("svg-to-pdfkit"), { PDFDocument: Other, setDashPattern, setLineCap, moveTo, lineTo, stroke } = require("pdf-lib");
const dashed = (bytes) => [...Buffer.from(bytes).toString("latin1").matchAll(/\[([\d. ]+)\] 0 d/g)].map((match) => match[1].trim()).join(", ") || "no pattern";
const made = (how) => new Promise((done) => {
  try {
    const document = new PDFDocument({ compress: false }), parts = [];
    document.on("data", (part) => parts.push(part)).on("end", () => done("dashes " + dashed(Buffer.concat(parts))));
    how(document);
    document.end();
  } catch (error) {
    done(error.message);
  }
});
(async () => {
  for (const pattern of [[4, 1], [0, 2], [8, 2, 0, 2]]) {
    console.log(`pdfkit, ${pattern}: ${await made((page) => page.lineCap("round").dash(pattern).moveTo(10, 10).lineTo(90, 10).stroke())}`);
    const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="100" height="20"><path d="M10 10H90" stroke="#000" stroke-linecap="round" stroke-dasharray="${pattern}"/></svg>`;
    console.log(`svg-to-pdfkit, ${pattern}: ${await made((page) => SVGtoPDF(page, svg, 0, 0))}`);
    const other = await Other.create(), page = other.addPage();
    page.pushOperators(setLineCap(1), setDashPattern(pattern, 0), moveTo(10, 10), lineTo(90, 10), stroke());
const bytes = Buffer.from(await other.save({ useObjectStreams: false })), start = bytes.indexOf("stream\n") + 7;
    console.log(`pdf-lib, ${pattern}: dashes ${dashed(inflateSync(bytes.subarray(start, bytes.indexOf("\nendstream", start))))}`);
  }
})();
JS
node dots.cjs >seen
expect_in seen <<'END'
pdfkit, 4,1: dashes 4 1
svg-to-pdfkit, 4,1: dashes 4 1
pdf-lib, 4,1: dashes 4 1
pdfkit, 0,2: dash([0,2], {}) invalid, lengths must be numeric and greater than zero
svg-to-pdfkit, 0,2: dash([0,2], {"phase":0}) invalid, lengths must be numeric and greater than zero
pdf-lib, 0,2: dashes 0 2
pdfkit, 8,2,0,2: dash([8,2,0,2], {}) invalid, lengths must be numeric and greater than zero
svg-to-pdfkit, 8,2,0,2: dash([8,2,0,2], {"phase":0}) invalid, lengths must be numeric and greater than zero
pdf-lib, 8,2,0,2: dashes 8 2 0 2
END
