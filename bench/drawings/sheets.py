# SPDX-License-Identifier: Apache-2.0
"""Prints how well sheets with dimensions define parts; bench/drawings/sheets starts it.

The sizes of a part are those of its exact faces, by FreeCAD; what a sheet says are the words that MuPDF finds in its PDF. Neither knows
what the program that drew it took the part for.
"""

import argparse
import collections
import dataclasses
import itertools
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import numpy
from FreeCAD import Vector  # before its modules
import Mesh
import Part

import ink
import parts
import programs

FINE = 0.02  # mm between the faces and the triangles of the STL file
NEAR = 0.01  # mm between free forms and the triangles that tell how far they reach
TIME_LIMIT = 120  # s of processor time for a sheet
SAME = 1e-4  # mm, between sizes of exact faces that are one; exporters write more digits
BORDER = 20, 10, 10, 10  # mm left, right, top and bottom: the letters and numbers of zones, by ISO 5457
TO_MM = 25.4 / 72  # from points
OVER = 0.05  # of the smaller box, which is slightly wider than its ink
CAPITAL = 0.72  # of the size of a font: the height of its digits, 0.68 to 0.74 in those of technical drawings
SMALLEST = 1.7  # mm: 1.8 by ISO 3098-1, less what CAPITAL may err by
THROUGH = 0.2  # of the shorter side of a box, by which a line that runs through a word is inside it


# --- What a part is: its sizes, from its faces

@dataclasses.dataclass
class Sizes:
    places: list  # for each axis, where planes lie across it and axes of bores and bosses pass
    ends: list  # for each axis, pairs of such a place, or of the middle of a sphere, and where its round face ends
    diameters: collections.Counter  # of cylinders of half a turn or more, by how many axes have them
    radii: set  # of the other cylinders, of tori and spheres
    circles: list  # through axes of equal bores: diameters, and the (axis, place) that each of them gives
    slopes: list  # for each plane askew and each cone, the sets of numbers of which one, said whole, defines it
    lengths: numpy.ndarray  # all that may truly be said of lengths
    angles: numpy.ndarray
    reach: numpy.ndarray  # how far free forms reach, within NEAR: the box of their surfaces is larger than they are
    free: int  # faces without sizes: their shape cannot be said by numbers


def distinct(values):
    found = []
    for value in sorted(values):
        if not found or value - found[-1] > SAME:
            found.append(value)
    return found


def differences(values):
    values = numpy.array(distinct(values))
    return numpy.abs(values[:, None] - values[None, :]).ravel()


def turn_of(face):
    low, high = face.ParameterRange[:2]
    return abs(high - low)


def along(direction):
    """The number of the axis that is parallel to a direction, or None."""
    nearest = int(numpy.argmax(numpy.abs(direction)))
    return nearest if abs(abs(direction[nearest]) - 1) < 1e-9 else None


def axis_of(surface):
    """Where the axis of a cylinder or cone passes, as a key for all of the same axis, and along which axis of the world it runs."""
    direction, place = numpy.array(surface.Axis), numpy.array(surface.Center)
    if direction[int(numpy.argmax(numpy.abs(direction)))] < 0:
        direction = -direction
    foot = place - direction * (place @ direction)
    return tuple(numpy.round(numpy.concatenate((foot, direction)), 4) + 0.0), foot, along(direction)


def sizes_of(shape):
    box = shape.BoundBox
    extents = [[box.XMin, box.XMax], [box.YMin, box.YMax], [box.ZMin, box.ZMax]]
    places, ends = [[], [], []], [[], [], []]
    turns, slopes, normals = collections.defaultdict(float), [], []
    diameters, radii, rings, free = collections.Counter(), set(), [], 0
    corners = numpy.array([tuple(vertex.Point) for vertex in shape.Vertexes]).reshape(-1, 3)
    axes = {}
    for face in shape.Faces:
        surface = face.Surface
        if isinstance(surface, Part.Plane):
            normal = numpy.array(surface.Axis)
            normals.append(normal)
            axis = along(normal)
            if axis is None:
                slopes.append(slope_of_plane(face, normal, places))
            else:
                places[axis].append(surface.Position[axis])
        elif isinstance(surface, Part.Cylinder):
            key, foot, axis = axis_of(surface)
            turns[key, round(surface.Radius, 4)] += turn_of(face)
            axes[key] = foot, axis
        elif isinstance(surface, Part.Cone):
            slopes.append(slope_of_cone(face, surface))
        elif isinstance(surface, Part.Toroid):
            radii.add(surface.MinorRadius)
            rings.append(surface.MajorRadius)
        elif isinstance(surface, Part.Sphere):
            radii.add(surface.Radius)
            for axis, middle in enumerate(surface.Center):
                ends[axis] += [(middle, middle - surface.Radius), (middle, middle + surface.Radius)]
        else:
            free += 1
    for (key, radius), turn in turns.items():
        if turn < math.pi - 1e-6:
            radii.add(radius)
            continue
        diameters[2 * radius] += 1
        foot, axis = axes[key]
        for other in range(3):
            if axis is not None and other != axis:
                places[other].append(foot[other])
                ends[other] += [(foot[other], foot[other] - radius), (foot[other], foot[other] + radius)]
    rims = circle_radii(shape)
    round_sizes = [*rims, *radii, *(d / 2 for d in diameters)]
    lengths = [differences([*places[i], *extents[i], *corners[:, i]]) for i in range(3)] + [round_sizes, [2 * r for r in round_sizes], rings, *centre_distances(axes)]
    circles = list(pitch_circles(turns, axes))
    lengths.append([diameter for diameter, _ in circles])
    towards = [a for _, given in circles for a in given_angles(given)]
    turned = [abs(math.degrees(math.acos(max(-1, min(1, a @ b))))) for a, b in itertools.combinations(distinct_normals(normals), 2)]
    angles = [angle for whole in turned for angle in (whole, 180 - whole)] + [a for slope in slopes for a in slope[0]] + towards
    return Sizes([distinct(values) for values in places], ends, diameters, radii, circles, slopes, numpy.unique(numpy.concatenate([numpy.ravel(v) for v in lengths])),
                 numpy.array(angles), reach_of(shape) if free else numpy.zeros(0), free)


def reach_of(shape):
    """Lengths, widths and heights between the ends and the places of corners."""
    points = numpy.array([tuple(point) for point in shape.tessellate(NEAR)[0]])
    corners = numpy.array([tuple(vertex.Point) for vertex in shape.Vertexes]).reshape(-1, 3)
    return numpy.concatenate([differences([points[:, i].min(), points[:, i].max(), *corners[:, i], 0]) for i in range(3)])


def distinct_normals(normals):
    return [numpy.array(row) for row in {tuple(numpy.round(normal, 6) + 0.0) for normal in normals}]


def circle_radii(shape):
    # An edge without length, as at the tip of a cone, has no curve.
    return [edge.Curve.Radius for edge in shape.Edges if not edge.Degenerated and isinstance(edge.Curve, Part.Circle)]


def slope_of_plane(face, normal, places):
    """Of a plane askew: its angles to the planes of the world, or the places of its corners on the axes across which it is inclined."""
    points = numpy.array([tuple(vertex.Point) for vertex in face.Vertexes]).reshape(-1, 3)
    turned = [math.degrees(math.acos(min(1, abs(value)))) for value in normal if abs(value) > 1e-9]
    runs = [float(numpy.ptp(points[:, i])) for i in range(3) if abs(normal[i]) > 1e-9 and len(points)]
    ends = [[(i, value) for value in distinct(points[:, i])] for i in range(3) if abs(normal[i]) > 1e-9 and len(points)]
    return [a for angle in turned for a in (angle, 90 - angle, 180 - angle, 90 + angle)], runs, [end for pair in ends for end in pair]


def slope_of_cone(face, surface):
    half = abs(math.degrees(surface.SemiAngle))
    return [half, 2 * half, 90 - half, 180 - 2 * half], distinct([2 * radius for radius in circle_radii(face)]), []


def centre_distances(axes):
    """Between parallel axes."""
    by_direction = collections.defaultdict(list)
    for key, (foot, _) in axes.items():
        by_direction[key[3:]].append(foot)
    return [[float(numpy.linalg.norm(a - b)) for a, b in itertools.combinations(feet, 2)] for feet in by_direction.values()]


def pitch_circles(turns, axes):
    """Circles about the middle of three or more axes of equal bores, or about the axis of anything round."""
    equal = collections.defaultdict(list)
    for (key, radius), turn in turns.items():
        if turn >= math.pi - 1e-6:
            equal[key[3:], radius].append(axes[key])
    for (direction, _), members in equal.items():
        feet = numpy.array([foot for foot, _ in members])
        middles = [feet.mean(0), *(foot for key, (foot, _) in axes.items() if key[3:] == direction)]
        for middle in middles if len(feet) >= 3 else ():
            radii = numpy.linalg.norm(feet - middle, axis=1)
            if radii.min() > SAME and numpy.ptp(radii) < SAME:
                yield 2 * float(radii[0]), [(i, round(foot[i], 4)) for foot in [middle, *feet] for i in range(3) if i != members[0][1]]
                break


def given_angles(given):
    """Of the places on a circle, from its middle, to the axes of the world and to each other."""
    points = numpy.array([value for _, value in given]).reshape(-1, 2) if len({axis for axis, _ in given}) == 2 else numpy.zeros((1, 2))
    turns = [math.degrees(math.atan2(*(point - points[0]))) for point in points[1:]] + [0, 90]
    return [angle % whole for a, b in itertools.permutations(turns, 2) for angle in (a - b,) for whole in (90, 180, 360)]


# --- What a sheet says

@dataclasses.dataclass
class Number:
    value: float
    digit: float  # the worth of its last digit
    kind: str  # "⌀", "R", "°" or nothing
    times: int

    def is_said(self, value):
        return abs(self.value - value) <= self.digit / 2 + 1e-9


NUMBERS = re.compile(r"(⌀|∅|Ø|SR|R|C)?(\d+(?:[.,]\d+)?)(°|[×x](?!\d*[×x]))?")
SIZE = re.compile(r"(?!\d+\.$)[\d.,⌀∅ØSRC°×x()±↧⌴⌵∨]+")  # what a word that says a size consists of; "1." is the number of a note


def words_of(pdf):
    """(text, box, height of digits) of each word beyond the border, in mm, y down."""
    text = subprocess.run(["mutool", "draw", "-q", "-F", "stext", "-o", "-", pdf], capture_output=True, check=True).stdout
    page = xml.etree.ElementTree.fromstring(text).find("page")
    width, height = (float(page.get(side)) * TO_MM for side in ("width", "height"))
    found = []
    for line in page.iter("line"):
        way = numpy.array([float(value) for value in line.get("dir").split()])
        chars = [(char.get("c"), numpy.array([float(char.get(key)) for key in "xy"]) * TO_MM, end_of(char, way) * TO_MM, float(font.get("size")) * TO_MM)
                 for font in line.iter("font") for char in font.iter("char")]
        for blank, group in itertools.groupby(chars, key=lambda char: char[0].isspace()):
            group = list(group)
            if blank:
                continue
            tall = CAPITAL * max(size for *_, size in group)
            box = box_of(group[0][1], group[-1][2], tall)
            if BORDER[0] < (box[0] + box[2]) / 2 < width - BORDER[1] and BORDER[2] < (box[1] + box[3]) / 2 < height - BORDER[3]:
                found.append(("".join(char for char, *_ in group), box, tall))
    return found


def end_of(char, way):
    """Where the next character starts, on the base line."""
    corners = numpy.array([float(value) for value in char.get("quad").split()]).reshape(4, 2)
    start = numpy.array([float(char.get(key)) for key in "xy"])
    return start + way * ((corners - start) @ way).max()


def box_of(start, end, tall):
    """The upright box of a word that stands on the line from start to end."""
    way = (end - start) / max(numpy.linalg.norm(end - start), 1e-9)
    corners = numpy.array([start, end, start + tall * numpy.array((way[1], -way[0])), end + tall * numpy.array((way[1], -way[0]))])
    return (*corners.min(0), *corners.max(0))


def numbers_of(words):
    numbers, times = [], 1
    for text, *_ in words:
        if not SIZE.fullmatch(text):
            times = 1
            continue
        for kind, digits, ends in NUMBERS.findall(text):
            if ends in ("×", "x") and re.fullmatch(r"\(?\d+[×x].*", text) and not kind:
                times = int(float(digits.replace(",", ".")))
                continue
            decimals = len(re.split("[.,]", digits)[1]) if re.search("[.,]", digits) else 0
            kind = {"∅": "⌀", "Ø": "⌀", "SR": "R"}.get(kind, kind)
            numbers.append(Number(float(digits.replace(",", ".")), 10.0 ** -decimals, "°" if ends == "°" else kind, times))
            times = 1
    return numbers


# --- How well they agree

@dataclasses.dataclass
class Sheet:
    needed: int  # sizes of the part
    missing: list  # those that the sheet does not say
    numbers: int
    false: list  # numbers that are no size of the part
    overlaps: list  # words that lie over each other
    crossed: list  # sizes with a line through them
    small: list  # words that are hard to read
    free: int

    def complete(self):
        return 1 - len(self.missing) / max(1, self.needed)

    def true(self):
        return 1 - len(self.false) / max(1, self.numbers)


def tied(places, ends, lengths):
    """The places on an axis to which a chain of numbers leads from the first; the middle of two that are tied is, by its centre line."""
    nodes = distinct([*places, *(end for pair in ends for end in pair)])
    joined = {i for i, node in enumerate(nodes) if places and abs(node - places[0]) < SAME}
    is_end = lambda a, b: any(abs(a - x) + abs(b - y) < SAME or abs(a - y) + abs(b - x) < SAME for x, y in ends)
    while True:
        more = {j for i in joined for j, node in enumerate(nodes) if j not in joined and
                (any(n.is_said(abs(node - nodes[i])) for n in lengths) or is_end(node, nodes[i]))}
        more |= {j for j, node in enumerate(nodes) if j not in joined and any(abs(node - place) < SAME for place in places) and
                 any(abs(nodes[a] + nodes[b] - 2 * node) < SAME for a, b in itertools.combinations(sorted(joined), 2))}
        if not more:
            return {round(nodes[i], 4) for i in joined}
        joined |= more


def missing_sizes(sizes, numbers):
    """The sizes of a part, one by one, as (whether it is said, words)."""
    lengths = [n for n in numbers if n.kind in ("", "C", "R")]  # R, of bends
    round_ones = [n for n in numbers if n.kind in ("⌀", "R", "")]
    circles = [n for n in numbers if n.kind == "⌀"]
    angles = [n for n in numbers if n.kind == "°"]
    said = []
    for diameter in sorted(sizes.diameters):
        said.append((any(n.is_said(diameter if n.kind != "R" else diameter / 2) for n in round_ones), f"⌀{diameter:g}"))
    for radius in distinct(sizes.radii):
        said.append((any(n.is_said(radius if n.kind == "R" else 2 * radius) for n in round_ones), f"R{radius:g}"))
    ends = [list(pairs) for pairs in sizes.ends]
    for diameter, given in sizes.circles:
        for axis in range(3) if any(n.is_said(diameter) for n in circles) else ():
            middle, *others = [value for other, value in given if other == axis] or [0]
            ends[axis] += [(middle, other) for other in others]
    reached = [tied(places, pairs, lengths) for places, pairs in zip(sizes.places, ends)]
    for axis, places in enumerate(sizes.places):
        said += [(round(place, 4) in reached[axis], f"{'xyz'[axis]} = {place:g}") for place in places[1:]]
    for possible, runs, ends in sizes.slopes:
        by_angle = any(n.is_said(angle) for n in angles for angle in possible)
        by_runs = len(runs) > 1 and all(any(n.is_said(run) for n in lengths) for run in runs)
        by_ends = bool(ends) and all(round(value, 4) in reached[axis] or any(
            n.is_said(abs(value - other)) for n in lengths for other in reached[axis]) for axis, value in ends)
        said.append((by_angle or by_runs or by_ends, f"slope of {min(possible):.4g}°"))
    return said


def is_true(sizes, number):
    slack = number.digit / 2 + 1e-9
    is_one = lambda values, more=0.0: bool(numpy.any(numpy.abs(values - number.value) <= slack + more))
    return is_one(sizes.angles) if number.kind == "°" else is_one(sizes.lengths) or is_one(sizes.reach, NEAR)


def overlap(a, b):
    """How much of the smaller box is under the other one."""
    across, down = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
    area = min((box[2] - box[0]) * (box[3] - box[1]) for box in (a, b))
    return across * down / area if across > 0 and down > 0 and area > 0 else 0


def runs_through(lines, box):
    """Whether a line is inside a box that is smaller by THROUGH on each side."""
    less = THROUGH * min(box[2] - box[0], box[3] - box[1])
    low, high = numpy.array(box[:2]) + less, numpy.array(box[2:]) - less
    start, run = lines[:, :2], lines[:, 2:] - lines[:, :2]
    with numpy.errstate(divide="ignore", invalid="ignore"):
        first, second = (low - start) / run, (high - start) / run
    beside = (run == 0) & ((start < low) | (start > high))
    enters = numpy.nanmax(numpy.where(run == 0, 0, numpy.minimum(first, second)), axis=1)
    leaves = numpy.nanmin(numpy.where(run == 0, 1, numpy.maximum(first, second)), axis=1)
    return bool(numpy.any(~beside.any(1) & (numpy.maximum(enters, 0) < numpy.minimum(leaves, 1))))


def judge(pdf, sizes):
    words = words_of(pdf)
    numbers = numbers_of(words)
    lines = numpy.concatenate(ink.read(pdf)) * (1, -1, 1, -1)
    said = missing_sizes(sizes, numbers)
    return Sheet(len(said), [what for is_said, what in said if not is_said], len(numbers),
                 [n for n in numbers if not is_true(sizes, n)],
                 [f"'{a}' and '{b}'" for (a, at, _), (b, there, _) in itertools.combinations(words, 2) if overlap(at, there) > OVER],
                 [text for text, box, _ in words if SIZE.fullmatch(text) and runs_through(lines, box)],
                 [f"'{text}' of {tall:.1f} mm" for text, _, tall in words if tall < SMALLEST], sizes.free)


# --- Programs

def epura(source):
    def run(part, output):
        return programs.measure([os.environ["EPURA"], "draw", f"{part}.{source}", "--views", "front,top,right", "--dimensions", "auto",
                                 "--sheet", "auto", "-o", output], TIME_LIMIT)
    return run


# Of the programs of the bench, the others have dimensions only by hand.
SHEETS = (("epura", "STEP", epura("step")), ("epura", "STL", epura("stl")))


def row(name, part, sheet):
    said = f"{sheet.needed - len(sheet.missing)} of {sheet.needed}"
    return f"| {name} | {part} | {said} | {sheet.true():.3f} | {sheet.numbers} | {len(sheet.overlaps)} | {len(sheet.crossed)} | {len(sheet.small)} | {sheet.free} |"


def errors_of(name, part, sheet):
    number = lambda n: f"{n.kind if n.kind != '°' else ''}{n.value:g}{'°' if n.kind == '°' else ''}"
    told = ((sheet.missing, "not said"), ([number(n) for n in sheet.false], "no size of the part"), (sheet.overlaps, "over each other"),
            (sheet.crossed, "with a line through it"), (sheet.small, "too small"))
    return [f"- {name}, {part}: {what}: {', '.join(found)}" for found, what in told if found]


def shape_of(name, folder):
    """The shape of a part of parts.py or of a STEP file, and its files in the folder."""
    shape = Part.read(str(name)) if pathlib.Path(name).suffix.lower() in (".step", ".stp") else parts.MADE[name]()
    if len(shape.Solids) != 1:
        sys.exit(f"sheets: {name} has {len(shape.Solids)} bodies; the sizes of each are for a sheet of its own")
    stem = folder / pathlib.Path(name).stem
    shape.exportStep(f"{stem}.step")
    points, triangles = shape.tessellate(FINE)
    Mesh.Mesh([[points[i] for i in triangle] for triangle in triangles]).write(f"{stem}.stl")
    return stem, shape


def main(words):
    parser = argparse.ArgumentParser(prog="bench/drawings/sheets", description="How well sheets with dimensions define parts.")
    parser.add_argument("--read", metavar="SHEET.pdf", help="judge this sheet of one part, of any program")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for parts and sheets")
    parser.add_argument("parts", nargs="*", default=[], help="parts of parts.py, or STEP files; all of parts.py that are one body")
    given = parser.parse_args(words)
    names = given.parts or [name for name in parts.MADE if name != "clamp"]  # which is an assembly
    if given.read and len(names) != 1:
        parser.error("--read needs the name of one part")
    with tempfile.TemporaryDirectory() as temporary:
        folder = (given.keep or pathlib.Path(temporary)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        rows, errors = [], []
        for name in names:
            stem, shape = shape_of(name, folder)
            sizes = sizes_of(shape)
            for program, source, run in ((given.read, "", None),) if given.read else SHEETS:
                label = f"{program} {source}".strip()
                try:
                    sheet = pathlib.Path(given.read or f"{stem}-{source}.pdf")
                    if run:
                        run(stem, sheet)
                    found = judge(sheet, sizes)
                except (programs.Refusal, subprocess.CalledProcessError, ValueError) as refusal:
                    rows.append(f"| {label} | {stem.name} | {refusal} | | | | | | |")
                    continue
                rows.append(row(label, stem.name, found))
                errors += errors_of(label, stem.name, found)
    print("Errors:\n\n" + ("\n".join(errors) or "none"))
    print("\n| program | part | sizes said | true | numbers | words over words | sizes with lines | small words | free forms |\n|---|---|---|---|---|---|---|---|---|")
    print("\n".join(rows))


if __name__ == "__main__":
    main(sys.argv[1:])
