#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-path-parse 1.1.3 (absNormalize) takes the last corner of a closed outline for where the next one begins, instead of its first corner: a hole
# whose path begins by a relative m, as Inkscape and SVGO write it, leaves its plate. With absolute coordinates it stays. Believed: after z
# the current point is where the outline began (SVG 1.1, 8.3.3), as svgpath 2.6.0 has it.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-path-parse@1.1.3 svgpath@2.6.0
cat >paths.cjs <<'JS'
const { pathParse, serializePath } = require('svg-path-parse'), svgpath = require('svgpath');
for (const [name, d] of [['a plate with a hole', 'm0 0h20v20h-20zm5 5h10v10h-10z'], ['the same, absolute', 'M0 0H20V20H0ZM5 5H15V15H5Z'], ['a line after z', 'M0 0H20V20H0Zl5 5']])
  console.log(`${name}: ${serializePath(pathParse(d).absNormalize({ round: 3 }))}, svgpath ${svgpath(d).abs().round(3)}`);
JS
node paths.cjs >seen
expect_in seen <<'END'
a plate with a hole: M0 0H20V20H0ZM5 25H15V35H5Z, svgpath M0 0H20V20H0ZM5 5H15V15H5Z
the same, absolute: M0 0H20V20H0ZM5 5H15V15H5Z, svgpath M0 0H20V20H0ZM5 5H15V15H5Z
a line after z: M0 0H20V20H0ZL5 25, svgpath M0 0H20V20H0ZL5 5
END
