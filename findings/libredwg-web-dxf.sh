#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @mlightcad/libredwg-web 0.7.14, "a DWG/DXF JavaScript parser" by its page and its type Dwg_File_Type, makes an empty drawing of every DXF:
# no entity, no layer, no message. What its page names as left out of the package is writing DXF, not reading it. dxf-json 0.14.1,
# whose interface it follows, reads the same file. Believed: the line and the circle, or an error.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @mlightcad/libredwg-web@0.7.14 dxf-json@0.14.1
printf '%s\n' 0 SECTION 2 ENTITIES 0 LINE 8 0 10 0 20 0 30 0 11 10 21 0 31 0 0 CIRCLE 8 0 10 5 20 5 30 0 40 3 0 ENDSEC 0 EOF >part.dxf
cat >read.mjs <<'JS'
import { readFileSync } from 'fs';
import { DxfParser } from 'dxf-json';
import { Dwg_File_Type, LibreDwg } from '@mlightcad/libredwg-web';
const library = await LibreDwg.create('./node_modules/@mlightcad/libredwg-web/wasm/');
const bytes = new Uint8Array(readFileSync('part.dxf'));
console.log(`libredwg-web: ${library.convert(library.dwg_read_data(bytes.buffer, Dwg_File_Type.DXF)).entities.length} entities`);
console.log(`dxf-json: ${new DxfParser().parseSync(readFileSync('part.dxf', 'utf8')).entities.length} entities`);
JS
node read.mjs >seen 2>&1
expect_in seen <<'END'
libredwg-web: 0 entities
dxf-json: 2 entities
END
