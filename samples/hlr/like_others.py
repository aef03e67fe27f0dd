# SPDX-License-Identifier: Apache-2.0
"""epura.hlr in the place of what other programs draw hidden lines with; each takes what they take, and returns arrays."""
import numpy as np

import epura


def project_to_viewport(shape, viewport_origin, viewport_up=(0, 0, 1), look_at=(0, 0, 0)):
    """As build123d: visible and hidden edges, seen from a point in parallel projection."""
    direction = np.subtract(viewport_origin, look_at)
    curves = epura.hlr(shape, direction=direction, up=viewport_up, target=look_at)
    return curves.visible, curves.hidden


def project_ex(shape, direction=(0, 0, 1), up=(0, 1, 0)):
    """As FreeCAD's TechDraw.projectEx: visible sharp, smooth and outline edges, then the hidden ones."""
    curves = epura.hlr(shape, direction=direction, up=up, kinds=("contour", "boundary", "crease", "intersection", "tangent"))
    looks = [("boundary", "crease", "intersection"), ("tangent",), ("contour",)]
    return [[curve.points for curve in curves.curves if curve.visible == visible and curve.kind in kinds]
            for visible in (True, False) for kinds in looks]


def get_svg(shape, projection_dir=(-1.75, 1.1, 5), width=800, margin=20):
    """As CadQuery's exporters.getSVG: the text of an SVG file, hidden lines dashed."""
    curves = epura.hlr(shape, direction=projection_dir, up=(0, 1, 0))
    points = np.concatenate([curve.points for curve in curves.curves])
    low, high = points.min(axis=0), points.max(axis=0)
    scale = (width - 2 * margin) / (high[0] - low[0])
    height = (high[1] - low[1]) * scale + 2 * margin
    lines = []
    for curve in curves.curves:
        page = (curve.points - low) * [scale, -scale] + [margin, height - margin]
        dashes = "" if curve.visible else ' stroke-dasharray="6 3"'
        lines.append(f'<polyline points="{" ".join(f"{x:.2f},{y:.2f}" for x, y in page)}"{dashes}/>')
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height:.0f}">'
            f'<g fill="none" stroke="black">{"".join(lines)}</g></svg>')


def get_dxf(shape, projection_dir=(-1.75, 1.1, 5)):
    """As CadQuery's exporters.exportDXF of a projection: the text of a DXF file, lines on the layers VISIBLE and HIDDEN."""
    rows = ["0", "SECTION", "2", "ENTITIES"]
    for curve in epura.hlr(shape, direction=projection_dir, up=(0, 1, 0)).curves:
        for (x0, y0), (x1, y1) in zip(curve.points, curve.points[1:]):
            rows += ["0", "LINE", "8", "VISIBLE" if curve.visible else "HIDDEN",
                     "10", f"{x0:.6f}", "20", f"{y0:.6f}", "11", f"{x1:.6f}", "21", f"{y1:.6f}"]
    return "\n".join([*rows, "0", "ENDSEC", "0", "EOF", ""])
