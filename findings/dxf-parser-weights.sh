#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# dxf-parser 1.1.2 of npm says that a spline is rational, and drops its weights (group 41): what it gives of the exact arc of a quarter
# circle is a parabola.
# Believed: weights beside knots and control points, as group 73 and 72 announce them.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages dxf-parser@1.1.2
debian_packages python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >write.py <<'PY'
import ezdxf
drawing = ezdxf.new("R2000")
space = drawing.modelspace()
spline = space.add_rational_spline([(10, 0), (10, 10), (0, 10)], [1, 0.5**0.5, 1], degree=2, knots=[0, 0, 0, 1, 1, 1])
space.add_hatch().paths.add_polyline_path([(0, 0), (40, 0), (40, 40), (0, 40)])
drawing.saveas("spline.dxf")
print("ezdxf: middle at radius %.3f" % spline.construction_tool().point(0.5).magnitude)
PY
cat >read.cjs <<'JS'
const parser = require('dxf-parser');
const { entities } = new (parser.default || parser)().parseSync(require('fs').readFileSync('spline.dxf', 'utf8'));
console.log('entities:', entities.map(entity => entity.type).join(' '));
const spline = entities[0], [a, b, c] = spline.controlPoints;
console.log('rational:', spline.rational, 'knots:', spline.knotValues.length, 'weights anywhere:', /0\.7071/.test(JSON.stringify(spline)));
console.log('middle of what is left: at radius', Math.hypot((a.x + 2 * b.x + c.x) / 4, (a.y + 2 * b.y + c.y) / 4).toFixed(3));
JS
python3 write.py >seen
node read.cjs >>seen
expect_in seen <<'END'
ezdxf: middle at radius 10.000
entities: SPLINE
rational: true knots: 6 weights anywhere: false
middle of what is left: at radius 10.607
END
