#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# npm's parse-stl 1.0.2 and stl 1.1.1 take tabs in an ASCII STL for no white space: if they stand between the numbers of a line, all facets come, and
# none has a whole corner, so that each size is no number. Nothing is said. Tabs that indent lines, and blanks, several in a row, too, are
# right. Believed: as three 0.187.0 reads them, since numbers are separated by white space of any kind.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages parse-stl@1.0.2 stl@1.1.1 three@0.187.0
cat >read.mjs <<'JS'
import { readFileSync } from "node:fs";
import { STLLoader } from "three/addons/loaders/STLLoader.js";
import parse from "parse-stl";
import stl from "stl";
const told = (facets) => {
  const numbers = facets.flat(2), whole = facets.every((facet) => facet.length == 3 && facet.every((corner) => corner.length == 3 && corner.every(Number.isFinite)));
  return facets.length ? `${facets.length} facets${whole ? `, ${Math.min(...numbers)} to ${Math.max(...numbers)}` : " without whole corners"}` : "nothing";
};
for (const name of ["blanks", "several blanks", "tabs before words", "tabs between words"]) {
  const file = readFileSync(name + ".stl"), mesh = parse(file);
  const flat = [...new STLLoader().parse(file.toString()).attributes.position.array];
  const facets = [...Array(flat.length / 9).keys()].map((i) => [0, 3, 6].map((k) => flat.slice(9 * i + k, 9 * i + k + 3)));
  console.log(`${name}: parse-stl ${told(mesh.cells.map((cell) => cell.map((i) => mesh.positions[i])))}; stl ${told(stl.toObject(file).facets.map((it) => it.verts))}; three.js ${told(facets)}`);
}
JS
box_stl part 0 >blanks.stl
sed 's/ \([0-9]\)/   \1/g' blanks.stl >"several blanks.stl"
sed 's/^  */\t/' blanks.stl >"tabs before words.stl"
sed 's/ \([0-9]\)/\t\1/g' blanks.stl >"tabs between words.stl"
node read.mjs >seen
expect_in seen <<'END'
blanks: parse-stl 12 facets, 0 to 10; stl 12 facets, 0 to 10; three.js 12 facets, 0 to 10
several blanks: parse-stl 12 facets, 0 to 10; stl 12 facets, 0 to 10; three.js 12 facets, 0 to 10
tabs before words: parse-stl 12 facets, 0 to 10; stl 12 facets, 0 to 10; three.js 12 facets, 0 to 10
tabs between words: parse-stl 12 facets without whole corners; stl 12 facets without whole corners; three.js 12 facets, 0 to 10
END
