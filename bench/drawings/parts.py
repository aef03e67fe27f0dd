# SPDX-License-Identifier: Apache-2.0
"""Parts of the bench, mm: made here by FreeCAD's module Part, and free for any use under the licence above.

Each has what one kind of drawing error needs: walls seen edge-on, bores behind bores, tangent faces, curves where surfaces cross, outlines
that end in cusps, bodies that touch nothing.
"""

import math

from FreeCAD import Vector  # before its modules
import Part

X, Y, Z = Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)


def box(size, at=(0, 0, 0)):
    return Part.makeBox(*size, Vector(*at))


def cylinder(radius, height, at=(0, 0, 0), axis=Z):
    return Part.makeCylinder(radius, height, Vector(*at), axis)


def bracket():
    """An angle with a rib, and holes in both legs."""
    angle = box((60, 40, 8)).fuse(box((8, 40, 50)))
    rib = Part.Face(Part.makePolygon([Vector(8, 17, 8), Vector(45, 17, 8), Vector(8, 17, 42), Vector(8, 17, 8)])).extrude(Vector(0, 6, 0))
    holes = [cylinder(4, 20, (48, y, -5)) for y in (10, 30)] + [cylinder(5, 20, (-5, y, 38), X) for y in (9, 31)]
    return angle.fuse(rib).cut(Part.makeCompound(holes)).removeSplitter()


def flange():
    """A disc with a hub, a bore and six holes around it."""
    disc = cylinder(40, 10).fuse(cylinder(20, 35))
    holes = [cylinder(4, 20, (30 * math.cos(a), 30 * math.sin(a), -5)) for a in (k * math.pi / 3 for k in range(6))]
    return disc.cut(Part.makeCompound([cylinder(12, 60, (0, 0, -5)), *holes])).removeSplitter()


def shaft():
    """Steps along x with chamfers, a groove and a keyway."""
    steps = cylinder(10, 30, (0, 0, 0), X).fuse(cylinder(15, 40, (30, 0, 0), X)).fuse(cylinder(8, 30, (70, 0, 0), X)).removeSplitter()
    ends = [edge for edge in steps.Edges if edge.BoundBox.XLength < 1e-6 and edge.BoundBox.XMin in (0, 100)]
    groove = cylinder(30, 3, (50, 0, 0), X).cut(cylinder(13, 3, (50, 0, 0), X))
    return steps.makeChamfer(1.5, ends).cut(groove).cut(box((16, 5, 10), (8, -2.5, 7)))


def tee():
    """Two pipes that cross: curves of the fourth order, outside and in the bores."""
    return cylinder(15, 90, (-45, 0, 0), X).fuse(cylinder(10, 40)).cut(cylinder(12, 90, (-45, 0, 0), X)).cut(cylinder(7, 50)).removeSplitter()


def rounded():
    """A block whose edges are all rounded: smooth edges, which need not be drawn, and outlines without any edge."""
    block = box((50, 30, 20))
    return block.makeFillet(5, block.Edges)


def housing():
    """A box with a pocket of round corners, a slot through its back and blind holes on its rim."""
    outside = box((70, 50, 30))
    pocket = box((54, 34, 30), (8, 8, 6))
    pocket = pocket.makeFillet(6, [edge for edge in pocket.Edges if edge.BoundBox.ZLength > 1])
    blind = [cylinder(2, 12, (x, y, 18)) for x in (4, 66) for y in (4, 46)]
    return outside.cut(pocket).cut(box((20, 20, 8), (25, 35, 12))).cut(Part.makeCompound(blind))


def cone():
    """A hollow cone with a cross bore: hyperbolas, and outlines that are no edges."""
    return Part.makeCone(30, 12, 50).cut(Part.makeCone(24, 6, 50)).cut(cylinder(6, 80, (-40, 0, 20), X))


def link():
    """Two balls with a bar between them, and a hole in each."""
    balls = Part.makeSphere(15).fuse(Part.makeSphere(12, Vector(60, 0, 0))).fuse(cylinder(6, 60, (0, 0, 0), X))
    return balls.cut(Part.makeCompound([cylinder(5, 60, (x, 0, -30)) for x in (0, 60)])).removeSplitter()


def elbow():
    """A quarter of a pipe bend with straight ends: outlines of a torus, with cusps."""
    outside, inside = (Part.makeTorus(30, radius, Vector(0, 0, 0), Z, -180, 180, 90) for radius in (10, 7))
    bend = outside.cut(inside)
    straight = [cylinder(10, 20, (30, -20, 0), Y).cut(cylinder(7, 20, (30, -20, 0), Y))]
    return bend.fuse(straight[0]).removeSplitter()


def duct():
    """From a square to a circle: free surfaces."""
    square = Part.makePolygon([Vector(x, y, 0) for x, y in ((-20, -20), (20, -20), (20, 20), (-20, 20), (-20, -20))])
    return Part.makeLoft([square, Part.Wire(Part.makeCircle(12, Vector(10, 0, 40)))], True)


MADE = {part.__name__: part for part in (bracket, flange, shaft, tee, rounded, housing, cone, link, elbow, duct)}
