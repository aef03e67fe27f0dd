#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# rgl 1.0.1 (3D models in R) writes each normal of an STL, binary or ASCII, into the body, against the order of the corners, which is right: programs
# that go by normals have it inside out, such as JSCAD (@jscad/stl-deserializer 2.1.30), where a body of 1000 mm3 has -1000, and cuts where
# it should add. ASCII files end without "endsolid", so that JSCAD reads nothing of them. Nothing is said. Believed: normals look out of
# the body, by the right-hand rule of the corners, and the end that ASCII STL has.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages r-base-core=4.2.2.20221110-2 r-cran-rgl=1.0.1-1
npm_packages @jscad/stl-deserializer@2.1.30 @jscad/modeling@2.13.0
R_of_packages() {  # SCRIPT
  EDITOR=vi PAGER=cat R_HOME=$work/root/usr/lib/R R_SHARE_DIR=$work/root/usr/share/R/share R_LIBS=$work/root/usr/lib/R/site-library \
    LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$work/root/usr/lib/R/lib root/usr/lib/R/bin/exec/R --no-echo --no-restore --vanilla --file="$1"
}
cat >write.R <<'R'
options(rgl.useNULL = TRUE)
library(rgl)
corners <- rbind(c(0, 0, 0), c(10, 0, 0), c(0, 20, 0), c(0, 0, 30))
facets <- rbind(c(1, 3, 2), c(1, 2, 4), c(2, 3, 4), c(1, 4, 3))
shade3d(tmesh3d(t(corners), t(facets), homogeneous = FALSE))
writeSTL("ascii.stl", ascii = TRUE)
writeSTL("binary.stl")
R
R_of_packages write.R >messages 2>&1 || { tail -n 3 messages; exit 1; }
cat >read.js <<'JS'
const { readFileSync } = require("fs");
const { deserialize } = require("@jscad/stl-deserializer");
const { measureVolume } = require("@jscad/modeling").measurements;
const unit = (v) => v.map((x) => (x / Math.hypot(...v)).toFixed(2)).join(" ");
const told = (normal, [a, b, c]) => {
  const u = b.map((x, i) => x - a[i]), v = c.map((x, i) => x - a[i]);
  const right = [0, 1, 2].map((i) => u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]);
  return `normal ${unit(normal)}, by the corners ${unit(right)}`.replace(/-0\.00/g, "0.00");
};
const text = readFileSync("ascii.stl", "utf8"), binary = readFileSync("binary.stl");
const numbers = (word) => [...text.matchAll(new RegExp(`${word} +(\\S+) (\\S+) (\\S+)`, "g"))].map((it) => it.slice(1).map(Number));
const corners = numbers("vertex");
numbers("facet normal").forEach((normal, i) => console.log(`ASCII: ${told(normal, corners.slice(3 * i, 3 * i + 3))}`));
for (let i = 0; i < binary.readUInt32LE(80); ++i) {
  const [normal, ...facet] = [0, 1, 2, 3].map((k) => [0, 4, 8].map((at) => binary.readFloatLE(84 + 50 * i + 12 * k + at)));
  console.log(`binary: ${told(normal, facet)}`);
}
console.log(`ASCII: the last word is ${text.trim().split(/\s+/).pop()}, JSCAD reads ${[deserialize({ output: "geometry" }, text)].flat().length} bodies`);
const bytes = binary.buffer.slice(binary.byteOffset, binary.byteOffset + binary.length);
console.log(`binary, read by JSCAD: volume ${measureVolume(deserialize({ output: "geometry" }, bytes)).toFixed(0)}`);
JS
node read.js >seen
expect_in seen <<'END'
ASCII: normal 0.00 0.00 1.00, by the corners 0.00 0.00 -1.00
ASCII: normal 0.00 1.00 0.00, by the corners 0.00 -1.00 0.00
ASCII: normal -0.86 -0.43 -0.29, by the corners 0.86 0.43 0.29
ASCII: normal 1.00 0.00 0.00, by the corners -1.00 0.00 0.00
binary: normal 0.00 0.00 1.00, by the corners 0.00 0.00 -1.00
binary: normal 0.00 1.00 0.00, by the corners 0.00 -1.00 0.00
binary: normal -0.86 -0.43 -0.29, by the corners 0.86 0.43 0.29
binary: normal 1.00 0.00 0.00, by the corners -1.00 0.00 0.00
ASCII: the last word is endfacet, JSCAD reads 0 bodies
binary, read by JSCAD: volume -1000
END
