#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# HP-GL/2 has arcs by three points (AT, RT). hp2xx 3.4.4 draws other circles through them, if any: for a quarter of a circle of 100 mm
# one of 346 mm across, for a half circle a piece of one that is 1.6 km wide. The same arcs by centre and angle (AA) are exact. Believed: equal within the
# chord tolerance.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages hp2xx=3.4.4-12+b1
while read -r name arc; do
  printf 'IN;SP1;PU4000,0;PD;%s;PU;SP0;' "$arc" >arc.plt
  hp2xx -q -t -c 14 -m dxf -f arc.dxf arc.plt 2>/dev/null
  python3 - "$name" <<'PY'
import sys
words = [word.strip() for word in open("arc.dxf")]
entities = [number for number, pair in enumerate(zip(words[::2], words[1::2])) if pair == ("2", "ENTITIES")][0]
ends = {code: [] for code in ("10", "11", "20", "21")}
for code, value in list(zip(words[::2], words[1::2]))[entities:]:
    if code in ends:
        ends[code].append(float(value))
wide, high = (max(ends[a] + ends[b]) - min(ends[a] + ends[b]) for a, b in (("10", "11"), ("20", "21")))
print(f"{sys.argv[1]}: {wide:.0f} mm wide, {high:.0f} mm high")
PY
done >seen <<'ARCS'
quarter,AA AA0,0,90
quarter,AT AT2828,2828,0,4000
quarter,RT RT-1172,2828,-4000,4000
half,AA AA0,0,180
half,AT AT0,4000,-4000,0
ARCS
expect_in seen <<'END'
quarter,AA: 100 mm wide, 100 mm high
quarter,AT: 346 mm wide, 346 mm high
quarter,RT: 346 mm wide, 346 mm high
half,AA: 200 mm wide, 100 mm high
half,AT: 1600000 mm wide, 331400 mm high
END
