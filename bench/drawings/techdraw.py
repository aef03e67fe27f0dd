# SPDX-License-Identifier: Apache-2.0
"""A view of a STEP file by FreeCAD's TechDraw:  python3 techdraw.py PART.step X Y Z OUT.svg [CUT]

With CUT, a section by the plane y = CUT. The lines are those that the view gives to scripts; its own DXF does not tell hidden lines from visible ones (findings/freecad-techdraw-hidden.sh).
"""

import sys

import FreeCAD
from FreeCAD import Vector  # before its modules
import Part
import TechDraw

TEMPLATE = '<svg xmlns="http://www.w3.org/2000/svg" width="297mm" height="210mm" viewBox="0 0 297 210"></svg>'
CHORD = 0.01  # mm


def main(part, x, y, z, output, cut=None):
    with open(output, "w") as file:
        file.write(TEMPLATE)
    document = FreeCAD.newDocument("d")
    body = document.addObject("Part::Feature", "Part")
    body.Shape = Part.read(part)
    page, template = document.addObject("TechDraw::DrawPage", "Page"), document.addObject("TechDraw::DrawSVGTemplate", "Template")
    template.Template = output
    page.Template = template
    view = document.addObject("TechDraw::DrawViewPart", "View")
    page.addView(view)
    viewer = Vector(float(x), float(y), float(z))
    view.Source, view.Direction, view.ScaleType, view.Scale = [body], viewer, "Custom", 1
    view.XDirection = Vector(1, 0, 0) if viewer.isEqual(Vector(0, 0, 1), 1e-9) else Vector(0, 0, 1).cross(viewer)
    view.HardHidden, view.SmoothVisible, view.SeamVisible = True, False, False
    document.recompute()
    if cut is not None:
        whole, view = view, document.addObject("TechDraw::DrawViewSection", "Section")
        page.addView(view)
        view.BaseView, view.Source, view.Direction, view.SectionNormal = whole, [body], viewer, viewer
        view.SectionOrigin, view.SectionDirection, view.ScaleType, view.Scale = Vector(0, float(cut), 0), "Up", "Custom", 1
        view.XDirection, view.SmoothVisible, view.SeamVisible = whole.XDirection, False, False
        document.recompute()
    lines = [(edge, "") for edge in view.getVisibleEdges()] + [(edge, ' stroke-dasharray="2 1"') for edge in view.getHiddenEdges()]
    with open(output, "w") as svg:
        svg.write('<svg xmlns="http://www.w3.org/2000/svg" width="1000mm" height="1000mm" viewBox="0 0 1000 1000" stroke="#000" fill="none">\n')
        for edge, style in lines:  # y is down in them
            points = " ".join(f"{p.x:.5f},{p.y:.5f}" for p in edge.discretize(Deflection=CHORD))
            svg.write(f'<polyline{style} points="{points}"/>\n')
        svg.write("</svg>\n")


main(*sys.argv[1:])
