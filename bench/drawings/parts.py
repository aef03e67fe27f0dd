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


def around(count, make):
    """What `make` gives for each of the angles, in radians, that divide a circle evenly."""
    return [make(2 * math.pi * k / count) for k in range(count)]


def plate_of(points, thickness, at=0):
    """The area within a polygon, from the height z = `at` upwards."""
    corners = [Vector(x, y, at) for x, y in points]
    return Part.Face(Part.makePolygon(corners + corners[:1])).extrude(Vector(0, 0, thickness))


def slot(x0, y0, x1, y1, width, z, depth):
    """A slot with round ends, from the height z downwards."""
    length, angle = math.hypot(x1 - x0, y1 - y0), math.degrees(math.atan2(y1 - y0, x1 - x0))
    ends = [cylinder(width / 2, depth, (x, 0, -depth)) for x in (0, length)]
    body = box((length, width, depth), (0, -width / 2, -depth)).multiFuse(ends).removeSplitter() if length else ends[0]
    body.rotate(Vector(0, 0, 0), Z, angle)
    body.translate(Vector(x0, y0, z))
    return body


def stud():
    """A turned bolt of rings as close as the turns of a thread, a neck, a keyway with round ends and chamfered ends."""
    outline = [(0, 0), (0, 5), (1, 6)]
    for k in range(16):
        outline += [(2 + 1.5 * k, 6), (2.75 + 1.5 * k, 5.1)]
    outline += [(26, 6), (27, 6), (27, 4.8), (30, 4.8), (30, 9), (68, 9), (70, 7), (70, 0)]
    corners = [Vector(x, 0, z) for x, z in outline]
    turned = Part.Face(Part.makePolygon(corners + corners[:1])).revolve(Vector(0, 0, 0), X, 360)
    return turned.cut(slot(40, 0, 58, 0, 5, 20, 15))


def sheet():
    """A bent sheet of 2 mm: two bends of inner radius 2, a long hole, round holes and a cut corner."""
    outside, inside = (body.makeFillet(radius, [edge for edge in body.Edges if edge.BoundBox.YLength > 1 and edge.BoundBox.ZMax < 3])
                       for body, radius in ((box((60, 40, 25)), 4), (box((56, 60, 40), (2, -10, 2)), 2)))
    holes = [slot(20, 20, 40, 20, 8, 5, 10), *(cylinder(3, 80, (-10, y, 16), X) for y in (10, 30))]
    corner = Part.Face(Part.makePolygon([Vector(50, 0, 26), Vector(50, 0, 15), Vector(50, 12, 26), Vector(50, 0, 26)])).extrude(Vector(20, 0, 0))
    return outside.cut(inside).cut(Part.makeCompound([*holes, corner]))


def casting():
    """A bearing block as cast: a foot, a round eye and ribs, with fillets between them, and machined faces and holes."""
    foot = box((80, 36, 10), (-40, -18, 0))
    foot = foot.makeFillet(8, [edge for edge in foot.Edges if edge.BoundBox.ZLength > 1])
    wall = plate_of([(-20, 0), (20, 0), (16, 40), (-16, 40)], 16, -8)
    wall.rotate(Vector(0, 0, 0), X, 90)
    wall.translate(Vector(0, 0, 5))
    raw = foot.multiFuse([wall, cylinder(18, 26, (0, -13, 42), Y), box((3, 30, 30), (-1.5, -15, 5))]).removeSplitter()
    inner = [edge for edge in raw.Edges if edge.BoundBox.ZLength < 1e-3 and abs(edge.BoundBox.ZMin - 10) < 1e-3 and edge.BoundBox.DiagonalLength < 60]
    raw = raw.makeFillet(2, [edge for edge in inner if abs(edge.BoundBox.XMin) < 21 and abs(edge.BoundBox.XMax) < 21])
    holes = [cylinder(4.5, 30, (x, 0, -5)) for x in (-30, 30)] + [cylinder(8, 5, (x, 0, 9)) for x in (-30, 30)]
    return raw.cut([cylinder(11, 60, (0, -30, 42), Y), *holes])  # one by one, as in gear


def clamp():
    """An assembly of five parts that touch: two plates, a disc between them and two bolts through all."""
    holes = lambda radius: Part.makeCompound([cylinder(radius, 80, (x, 0, -20)) for x in (-25, 25)])
    plates = [box((70, 30, 8), (-35, -15, z)).cut(holes(4)) for z in (0, 20)]
    spacer = cylinder(14, 12, (0, 0, 8)).cut(cylinder(6, 30, (0, 0, 0)))
    hexagon = lambda x: plate_of([(x + 7 * math.cos(a), 7 * math.sin(a)) for a in (k * math.pi / 3 for k in range(6))], 5, 28)
    bolts = [cylinder(4, 34, (x, 0, -6)).fuse(hexagon(x)).removeSplitter() for x in (-25, 25)]
    return Part.makeCompound([*plates, spacer, *bolts])


def engraved():
    """A label with round corners: letters of grooves with round ends, 0.8 mm deep, and holes in its corners."""
    plate = box((80, 30, 4))
    plate = plate.makeFillet(4, [edge for edge in plate.Edges if 3.9 < edge.BoundBox.ZLength])
    strokes = [(12, 8, 12, 22), (12, 8, 20, 8), (12, 15, 18, 15), (12, 22, 20, 22),  # E
               (28, 8, 28, 22), (28, 22, 36, 22), (36, 22, 36, 15), (36, 15, 28, 15),  # P
               (44, 8, 48, 22), (48, 22, 52, 8),  # A without its bar
               (60, 15, 60, 15), (66, 8, 66, 22)]  # a dot and an I
    groove = slot(*strokes[0], 1.6, 5, 1.8).multiFuse([slot(*stroke, 1.6, 5, 1.8) for stroke in strokes[1:]]).removeSplitter()
    holes = [cylinder(1.75, 10, (x, y, -2)) for x in (5, 75) for y in (5, 25)]
    return plate.cut(groove).cut(Part.makeCompound(holes))


def gear():
    """A spur gear of 14 involute teeth, module 4, with a bore, a keyway and four holes."""
    teeth, module = 14, 4
    pitch, root, tip = teeth * module / 2, (teeth / 2 - 1.25) * module, (teeth / 2 + 1) * module
    base = pitch * math.cos(math.radians(20))

    def roll(radius):
        """By how much of an angle the involute has moved on where it is that far out."""
        opened = math.sqrt((radius / base) ** 2 - 1)
        return opened - math.atan(opened)

    half = math.pi / (2 * teeth) + roll(pitch)  # of the angle of a tooth on its base circle
    radii = [base + (tip - base) * (k / 8) ** 2 for k in range(9)]
    flank = [(root, half), *((radius, half - roll(radius)) for radius in radii)]
    edges = []
    for middle in around(teeth, lambda angle: angle):
        at = lambda radius, angle: Vector(radius * math.cos(middle + angle), radius * math.sin(middle + angle), 0)
        for sign in (1, -1):
            involute = Part.BSplineCurve()
            involute.interpolate([at(radius, sign * angle) for radius, angle in flank[1:]])
            edges += [Part.makeLine(at(root, sign * half), at(base, sign * half)), involute.toShape()]
        end, next_tooth = flank[-1][1], 2 * math.pi / teeth - half
        edges += [Part.Arc(at(tip, -end), at(tip, 0), at(tip, end)).toShape(),
                  Part.Arc(at(root, half), at(root, math.pi / teeth), at(root, next_tooth)).toShape()]
    wheel = Part.Face(Part.Wire(Part.__sortEdges__(edges))).extrude(Vector(0, 0, 12))
    holes = around(4, lambda a: cylinder(3, 30, (14 * math.cos(a), 14 * math.sin(a), -5)))
    # One by one: of a compound, whose bodies must not touch, Open CASCADE leaves what fills the bore and its keyway.
    return wheel.cut([cylinder(5, 40, (0, 0, -5)), box((7, 3, 40), (0, -1.5, -5)), *holes])


def bottle():
    """A free-form housing: a loft through four ellipses, hollow from below, with a round port and a long hole in its side."""
    def loft(less):
        rings = []
        for a, b, z in ((30, 20, 0), (34, 16, 20), (24, 22, 40), (12, 11, 60 - less)):
            ring = Part.Ellipse(Vector(0, 0, 0), max(a, b) - less, min(a, b) - less).toShape()
            ring.translate(Vector(0, 0, z))
            rings.append(Part.Wire(ring))
        return Part.makeLoft(rings, True)
    return loft(0).cut(loft(3)).cut(Part.makeCompound([cylinder(5, 30, (0, -40, 24), Y), cylinder(4, 60, (0, 0, 30))]))


def knob():
    """A knob with the points of a straight knurl: grooves along its axis and around it, and a blind bore."""
    grip = cylinder(15, 20).fuse(cylinder(8, 30)).removeSplitter()
    at = lambda radius, angle: (radius * math.cos(angle), radius * math.sin(angle))
    along = around(16, lambda a: plate_of([at(13.6, a), at(16, a - 0.13), at(16, a + 0.13)], 30, -5))
    rings = [Part.Face(Part.makePolygon([Vector(x, 0, z + h) for x, h in ((14, 0), (16, -1), (16, 1), (14, 0))])).revolve(Vector(0, 0, 0), Z, 360)
             for z in (5, 10, 15)]
    return grip.cut(Part.makeCompound(along)).cut(Part.makeCompound(rings)).cut(cylinder(4, 18, (0, 0, -1)))


def dome():
    """A thin half ball with a rim, and holes from its middle outwards and along its axis."""
    ball = Part.makeSphere(30).cut(Part.makeSphere(27)).common(box((80, 80, 40), (-40, -40, 0)))
    rim = cylinder(38, 4).cut(cylinder(28, 10, (0, 0, -2)))
    slanted = around(6, lambda a: Part.makeCylinder(4, 60, Vector(0, 0, 0), Vector(math.cos(a), math.sin(a), 1)))
    straight = around(8, lambda a: cylinder(2, 20, (34 * math.cos(a), 34 * math.sin(a), -5)))
    return ball.fuse(rim).cut([*slanted, *straight, cylinder(5, 40)]).removeSplitter()  # one by one, as in gear


def pipe():
    """A quarter of a pipe bend between two flanges with four holes each: a torus seen along its axis and through its bore."""
    turned = lambda radius: Part.Face(Part.Wire(Part.makeCircle(radius, Vector(45, 0, 0)))).revolve(Vector(0, 0, 0), Y, 90)
    ends = ((Vector(45, 0, 0), Z, X), (Vector(0, 0, -45), -X, Z))  # a middle, out of the pipe, across it
    rings = lambda radius: [Part.makeCylinder(radius, 6, place, out) for place, out, _ in ends]
    holes = [Part.makeCylinder(3, 10, place - out + (across * math.cos(a) + Y * math.sin(a)) * 18, out)
             for place, out, across in ends for a in (0.7 + k * math.pi / 2 for k in range(4))]
    # One by one: of a compound, whose bodies must not touch, Open CASCADE leaves discs across the bore.
    return turned(12).multiFuse(rings(24)).cut([turned(9), *rings(9), *holes]).removeSplitter()


MADE = {part.__name__: part for part in (
    bracket, flange, shaft, tee, rounded, housing, cone, link, elbow, duct, stud, sheet, casting, clamp, engraved,
    gear, bottle, knob, dome, pipe)}
