#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# dxf-doc 0.1.6 (npm) writes the steps from line to line of a hatch as they stand in a pattern file (.pat), along and across the line, where
# DXF has them (45, 46) along x and y of the drawing: lines at 45 degrees 3 mm apart stand 2.12 mm apart, at 30 degrees 2.6 mm, and upright
# ones all on each other. Level lines are right. Nothing is said. Believed: 3 mm, as ezdxf 0.18.1 writes the same pattern.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-ezdxf=0.18.1-1
npm_packages dxf-doc@0.1.6
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >write.cjs <<'JS'
const { DxfDocument } = require("dxf-doc");
const { Hatch } = require("dxf-doc/entities");
const { HatchPattern, PolylineBoundaryPath } = require("dxf-doc/entities/hatch");
for (const angle of [0, 30, 45, 90, 135]) {
  const document = new DxfDocument(), [pattern] = HatchPattern.parse(["*LINES, lines 3 apart", `${angle}, 0,0, 0,3`]);
  document.addEntities(new Hatch(document, [new PolylineBoundaryPath([[0, 0], [50, 0], [50, 20], [0, 20]])], pattern));
  require("fs").writeFileSync(`doc ${angle}.dxf`, document.dxf());
}
JS
cat >read.py <<'PY'
import math
import ezdxf

def line(path):
    (hatch,) = ezdxf.readfile(path).modelspace().query("HATCH")
    (line,) = hatch.pattern.lines
    angle = math.radians(line.angle)
    x, y = line.offset
    return f"step {x:.2f} {y:.2f}, {abs(y * math.cos(angle) - x * math.sin(angle)):.2f} apart"

for angle in (0, 30, 45, 90, 135):
    drawing = ezdxf.new("R2007")
    hatch = drawing.modelspace().add_hatch()
    hatch.paths.add_polyline_path([(0, 0), (50, 0), (50, 20), (0, 20)], is_closed=True)
    hatch.set_pattern_fill("LINES", angle=angle, definition=[[0, (0, 0), (0, 3), []]])
    drawing.saveas("ezdxf.dxf")
    print(f"lines at {angle} degrees: dxf-doc {line(f'doc {angle}.dxf')}; ezdxf {line('ezdxf.dxf')}")
PY
node write.cjs
python3 read.py >seen
expect_in seen <<'END'
lines at 0 degrees: dxf-doc step 0.00 3.00, 3.00 apart; ezdxf step 0.00 3.00, 3.00 apart
lines at 30 degrees: dxf-doc step 0.00 3.00, 2.60 apart; ezdxf step -1.50 2.60, 3.00 apart
lines at 45 degrees: dxf-doc step 0.00 3.00, 2.12 apart; ezdxf step -2.12 2.12, 3.00 apart
lines at 90 degrees: dxf-doc step 0.00 3.00, 0.00 apart; ezdxf step -3.00 0.00, 3.00 apart
lines at 135 degrees: dxf-doc step 0.00 3.00, 2.12 apart; ezdxf step -2.12 -2.12, 3.00 apart
END
