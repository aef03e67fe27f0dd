#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sheets of random parts, read as a checker reads them:  tests/random_sheets.py EPURA [--count N] [--first N] [--keep FOLDER]

FreeCAD (Debian) makes parts of seven families whose sizes are known here; epura draws them with automatic dimensions, sections and
hole tables; poppler reads the PDF. On each sheet no text lies over another one or beyond the page, no stroke runs through a text, each
diameter is noted as often as the part has it, radii, chamfers, depths and overall sizes are there, and no ⌀ is there that the part
lacks. `epura lint` finds nothing that is free, `--verify` no line that is wrong. A part is drawn from the seed and its number alone.
"""
import argparse
import collections
import concurrent.futures
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from xml.etree import ElementTree

MADE_BY_FREECAD = r"""
import json, sys
from FreeCAD import Vector
import Part

def solid(step):
    kind, at, axis = step["kind"], Vector(*step["at"]), Vector(*step["axis"])
    if kind == "box":
        return Part.makeBox(*step["size"], at)
    if kind == "cone":
        return Part.makeCone(step["radius"], step["end"], step["length"], at, axis)
    if kind == "prism":
        points = [at + Vector(*point) for point in step["points"]]
        return Part.Face(Part.makePolygon(points + points[:1])).extrude(axis)
    if kind == "pocket":
        box = Part.makeBox(*step["size"], at)
        upright = [e for e in box.Edges if abs(e.Vertexes[0].Z - e.Vertexes[1].Z) > 1e-6]
        return box.makeFillet(step["radius"], upright)
    if kind == "slot":
        length, radius, depth = step["size"]
        bar = Part.makeBox(length, 2 * radius, depth, at - Vector(0, radius, 0))
        return bar.fuse([Part.makeCylinder(radius, depth, at + Vector(x, 0, 0)) for x in (0, length)]).removeSplitter()
    return Part.makeCylinder(step["radius"], step["length"], at, axis)

for line in sys.stdin:
    part = json.loads(line)
    shape = None
    for step in part["steps"]:
        if step["do"] == "round":
            x, y = step["at"]
            edges = [e for e in shape.Edges if all(abs(v.X - x) + abs(v.Y - y) < 1e-6 for v in e.Vertexes) and len(e.Vertexes) == 2]
            shape = (shape.makeFillet if step["kind"] == "fillet" else shape.makeChamfer)(step["size"], edges)
            continue
        other = solid(step)
        shape = other if shape is None else shape.fuse(other) if step["do"] == "add" else shape.cut(other)
    shape.removeSplitter().exportStep(part["file"])
    print(part["file"], flush=True)
"""


def add(kind, **what):
    return {"do": "add", "kind": kind, "at": (0, 0, 0), "axis": (0, 0, 1), **what}


def cut(kind, **what):
    return {**add(kind, **what), "do": "cut"}


class Sizes:
    """What the sheet of a part must say; sizes of one kind differ, so that each is told by its number."""

    def __init__(self, lot):
        self.lot = lot
        self.diameters = collections.Counter()
        self.radii = collections.Counter()
        self.texts = []  # others that must be there
        self.either = []  # one of each must be there
        self.bores = collections.Counter()  # diameters of bores through several lugs: noted once, or once for each
        self.soft_radii = set()  # radii that need not be said

    def new(self, low, high, taken, step=1.0):
        while True:
            value = low + step * self.lot.randrange(int((high - low) / step) + 1)
            if all(abs(value - other) > 1e-9 for other in taken):
                return value


def plate(lot):
    """A block with features in cells of 30 mm: holes, blind and counterbored ones, slots, bosses; rounded or cut corners."""
    sizes = Sizes(lot)
    nx, ny = lot.randrange(2, 5), lot.randrange(1, 4)
    length, width = 30 * nx + lot.randrange(0, 12), 30 * ny + lot.randrange(10, 22)
    height = sizes.new(9, 27, ())
    steps = [add("box", size=(length, width, height))]
    sizes.texts += [length, width]
    cells = [(15 + 30 * i + (length - 30 * nx) // 2, 15 + 30 * j + (width - 30 * ny) // 2) for i in range(nx) for j in range(ny)]
    lot.shuffle(cells)
    used, rises = [], 0
    while cells and len(used) < 5:
        kind = lot.choice(("through", "through", "blind", "counterbore", "slot", "boss", "none"))
        count = min(len(cells), lot.choice((1, 1, 2, 4)))
        places, cells = cells[:count], cells[count:]
        if kind == "none":
            continue
        d = sizes.new(4, 14, used, 0.5)
        used.append(d)
        depth = lot.randrange(3, int(height) - 3)
        if kind == "counterbore":
            big = sizes.new(15, 22, used, 0.5)
            used.append(big)
        if kind == "boss":
            d, rise = d + 10, sizes.new(3, 12, ())
            if rises or d in used:
                continue
            rises = rise
            used.append(d)
        for x, y in places:
            if kind in ("through", "counterbore"):
                steps.append(cut("cylinder", at=(x, y, -1), radius=d / 2, length=height + 2))
            if kind == "counterbore":
                steps.append(cut("cylinder", at=(x, y, height - depth), radius=big / 2, length=depth + 1))
                sizes.diameters[big] += 1
            if kind == "blind":
                steps.append(cut("cylinder", at=(x, y, height - depth), radius=d / 2, length=depth + 1))
            if kind == "boss":
                steps.append(add("cylinder", at=(x, y, height - 1), radius=d / 2, length=rise + 1))
            if kind == "slot":
                steps.append(cut("slot", at=(x - 5, y, -1), size=(10, d / 2, height + 2)))
                sizes.soft_radii.add(d / 2)
            else:
                sizes.diameters[d] += 1
        if kind in ("blind", "counterbore"):
            sizes.texts.append(depth)
    sizes.texts.append(height + rises)
    for corner in ((0, 0), (length, 0), (0, width), (length, width)):
        kind = lot.choice(("fillet", "chamfer", "none"))
        if kind != "none":
            size = lot.choice((2, 3, 5))
            steps.append({"do": "round", "kind": kind, "at": corner, "size": size})
            if kind == "fillet":
                sizes.radii[size] += 1
    return steps, sizes


def turned(lot):
    """Steps along x that grow and fall, with a bore, a groove, a cross hole or a keyway."""
    sizes = Sizes(lot)
    count = lot.randrange(2, 5)
    used, at, steps, lengths, radii = [], 0, [], [], []
    for _ in range(count):
        d = sizes.new(16, 60, used, 2)
        used.append(d)
        length = sizes.new(15, 60, lengths)
        lengths.append(length)
        radii.append(d / 2)
        steps.append(add("cylinder", at=(at, 0, 0), axis=(1, 0, 0), radius=d / 2, length=length))
        sizes.diameters[d] += 1
        at += length
    sizes.texts.append(at)
    if lot.randrange(2):
        i = lot.randrange(1, count)
        d = 2 * radii[i] - 3
        start = sum(lengths[:i]) + 5
        if d not in used:
            used.append(d)
            steps += [cut("cylinder", at=(start, 0, 0), axis=(1, 0, 0), radius=radii[i] + 1, length=4),
                      add("cylinder", at=(start, 0, 0), axis=(1, 0, 0), radius=d / 2, length=4)]
            sizes.diameters[d] += 1
    if lot.randrange(2):
        d = sizes.new(5, 12, used)
        used.append(d)
        depth = lot.choice((at + 2, lengths[0] + 5))
        steps.append(cut("cylinder", at=(-1, 0, 0), axis=(1, 0, 0), radius=d / 2, length=depth + 1))
        sizes.diameters[d] += 1
        if depth < at:
            sizes.texts.append(depth)
    elif lot.randrange(2):
        d = sizes.new(4, 6, used)
        used.append(d)
        steps.append(cut("cylinder", at=(lengths[0] / 2, -40, 0), axis=(0, 1, 0), radius=d / 2, length=80))
        sizes.diameters[d] += 1
    return steps, sizes


def bracket(lot):
    """A base and an upright with holes in both, and a step or a notch of its own in the base."""
    sizes = Sizes(lot)
    length, width, height = lot.randrange(60, 120), lot.randrange(40, 80), lot.randrange(45, 90)
    base, wall = sizes.new(8, 16, ()), sizes.new(8, 16, ())
    steps = [add("box", size=(length, width, base)), add("box", size=(wall, width, height))]
    sizes.texts += [length, width, height, base, wall]
    used = []
    for axis in lot.sample(("x", "z"), lot.randrange(1, 3)):
        d = sizes.new(4, 10, used, 0.5)
        used.append(d)
        count = lot.choice((1, 2))
        for i in range(count):
            y = width * (i + 1) // (count + 1)
            at = (-1, y, (base + height) // 2) if axis == "x" else ((wall + length) // 2, y, -1)
            steps.append(cut("cylinder", at=at, axis=(1, 0, 0) if axis == "x" else (0, 0, 1), radius=d / 2, length=wall + base + 2))
            sizes.diameters[d] += 1
    kind = lot.choice(("step", "notch", "groove", "none"))
    deep, long = lot.randrange(2, int(base) - 3), lot.randrange(6, 14)
    if kind == "step":  # across the end of the base
        steps.append(cut("box", at=(length - long, -1, base - deep), size=(long + 1, width + 2, deep + 1)))
    if kind == "notch":  # through the base, in a corner
        steps.append(cut("box", at=(length - long, -1, -1), size=(long + 1, 9, base + 2)))
        sizes.texts.append(8)
    if kind == "groove":  # across the top of the upright
        steps.append(cut("box", at=(-1, width / 2 - long / 2, height - deep), size=(wall + 2, long, deep + 1)))
        sizes.texts.append(long)
    return steps, sizes


def square(x, y, z, length, width, depth):
    return {"at": (x, y, z), "size": (length, width, depth)}


def milled(lot):
    """A block with a pocket or a T-slot in its top, holes in its sides, countersinks, a row of holes at one pitch, a crossed groove."""
    sizes = Sizes(lot)
    length, width, height = lot.randrange(90, 140), lot.randrange(56, 80), lot.randrange(26, 36)
    steps = [add("box", size=(length, width, height))]
    sizes.texts += [length, width, height]
    used = []
    kind = lot.choice(("pocket", "tslot", "groove", "crossed", "island"))
    deep = lot.randrange(6, 12)
    if kind in ("pocket", "island"):
        long, wide, r = lot.randrange(36, 50), lot.randrange(24, 32), lot.choice((3, 4, 5, 6))
        steps.append(cut("pocket", **square(10, 12, height - deep, long, wide, deep + 1), radius=r))
        sizes.texts += [long, wide]
        sizes.either.append((deep, height - deep))
        sizes.radii[r] += 1
        if kind == "island":
            d = sizes.new(8, 12, used)
            used.append(d)
            steps.append(add("cylinder", at=(10 + long / 2, 12 + wide / 2, height - deep - 1), radius=d / 2, length=deep + 1))
            sizes.diameters[d] += 1
    if kind == "tslot":
        neck, head, top = lot.randrange(8, 12), lot.randrange(16, 22), lot.randrange(5, 8)
        steps.append(cut("box", **square(-1, 30 - neck / 2, height - top - 1, length + 2, neck, top + 2)))
        steps.append(cut("box", **square(-1, 30 - head / 2, height - top - 6, length + 2, head, 6)))
        sizes.texts += [neck, head]
    if kind in ("groove", "crossed"):
        wide = lot.randrange(8, 14)
        steps.append(cut("box", **square(-1, 20, height - deep, length + 2, wide, deep + 1)))
        sizes.texts.append(wide)
        if kind == "crossed":
            across = sizes.new(6, 16, (wide,))
            steps.append(cut("box", **square(30, -1, height - 4, across, width + 2, 5)))
            sizes.texts.append(across)
    sides = lot.sample(("row", "front", "right", "sink", "edge"), lot.randrange(2, 4))
    if "row" in sides:  # along the rear of the top
        d, count, pitch = sizes.new(4, 7, used, 0.5), lot.randrange(3, 7), lot.randrange(11, 15)
        used.append(d)
        for i in range(count):
            steps.append(cut("cylinder", at=(8 + pitch * i, width - 6, -1), radius=d / 2, length=height + 2))
        sizes.diameters[d] += count
    if "front" in sides:
        d, depth = sizes.new(4, 9, used, 0.5), lot.randrange(7, 11)
        used.append(d)
        for x in lot.choice(((20.5,), (20.5, 60.5), (25.5, 50.5, 75.5))):
            steps.append(cut("cylinder", at=(x, -1, 8), axis=(0, 1, 0), radius=d / 2, length=depth + 1))
            sizes.diameters[d] += 1
        sizes.texts.append(depth)
    if "right" in sides:
        d, depth = sizes.new(4, 9, used, 0.5), lot.randrange(9, 14)
        used.append(d)
        steps.append(cut("cylinder", at=(length + 1, width / 2 + 0.3, 9), axis=(-1, 0, 0), radius=d / 2, length=depth + 1))
        sizes.diameters[d] += 1
        sizes.texts.append(depth)
    if "sink" in sides:
        d = sizes.new(4, 7, used, 0.5)
        big = sizes.new(10, 14, used + [d], 0.5)
        used += [d, big]
        for y in (10.5, width - 20.5):
            steps.append(cut("cylinder", at=(length - 12, y, -1), radius=d / 2, length=height + 2))
            steps.append(cut("cone", at=(length - 12, y, height - big / 2), radius=0, end=big / 2 + 1, length=big / 2 + 1))
            sizes.diameters[d] += 1
            sizes.diameters[big] += 1
        sizes.texts.append(90)
    if "edge" in sides:
        size = lot.choice((1.5, 2.5, 3.5))
        for corner in ((0, 0), (0, width))[: lot.randrange(1, 3)]:
            steps.append({"do": "round", "kind": "chamfer", "at": corner, "size": size})
        sizes.texts.append(size)
    return steps, sizes


def wedge(lot):
    """A block with an inclined face, and holes square to that face; a foot or a step before it."""
    sizes = Sizes(lot)
    width, low, foot = lot.randrange(30, 60), lot.randrange(8, 20), lot.randrange(12, 40)
    angle = lot.choice((20, 25, 30, 40, 45, 50, 60))
    run = lot.randrange(36, 60)
    slope = math.tan(math.radians(angle))
    length, high = foot + run, low + run * slope
    outline = [(0, 0, 0), (length, 0, 0), (length, 0, high), (foot, 0, low), (0, 0, low)]
    steps = [add("prism", points=outline, axis=(0, width, 0))]
    sizes.texts += [width, length, low, foot]
    sizes.either.append((angle, 90 - angle, 180 - angle, 90 + angle, round(high, 2)))
    used, inward = [], (math.sin(math.radians(angle)), 0, -math.cos(math.radians(angle)))
    for kind in lot.sample(("through", "blind", "square", "none"), lot.randrange(1, 3)):
        d = sizes.new(5, 9, used, 0.5)
        used.append(d)
        along = lot.choice((0.35, 0.5, 0.6)) * run if kind != "square" else foot / 2
        if kind == "square":  # in the foot, upright
            steps.append(cut("cylinder", at=(along, width / 2, -1), radius=d / 2, length=low + 2))
            sizes.diameters[d] += 1
        elif kind in ("through", "blind") and not any(step.get("tilted") for step in steps):
            depth = lot.randrange(6, 9) if kind == "blind" else 3 * length
            for y in lot.choice(((width / 2,), (8, width - 8))):
                start = [foot + along - inward[0], y, low + along * slope - inward[2]]
                steps.append(cut("cylinder", at=start, axis=inward, radius=d / 2, length=depth + 1, tilted=True))
                sizes.diameters[d] += 1
            if kind == "blind":
                sizes.texts.append(depth)
    return steps, sizes


def shaft(lot):
    """Steps along x with undercuts, keyways, flats, a hexagon at one end, chamfers of the ends, a centre bore with countersink."""
    sizes = Sizes(lot)
    used, at, steps, lengths, radii = [], 0, [], [], []
    count = lot.randrange(2, 4)
    for _ in range(count):
        d = sizes.new(20, 60, used, 2)
        used.append(d)
        length = sizes.new(30, 60, lengths)
        lengths.append(length)
        radii.append(d / 2)
        steps.append(add("cylinder", at=(at, 0, 0), axis=(1, 0, 0), radius=d / 2, length=length))
        sizes.diameters[d] += 1
        at += length
    if lot.randrange(2):  # an undercut beside a shoulder
        i = lot.randrange(1, count)
        joint = sum(lengths[:i])
        thin, start = (i, joint) if radii[i] < radii[i - 1] else (i - 1, joint - 3)
        d = 2 * radii[thin] - lot.choice((1, 2, 3))
        if d not in used:
            used.append(d)
            steps += [cut("cylinder", at=(start, 0, 0), axis=(1, 0, 0), radius=radii[thin] + 0.01, length=3),
                      add("cylinder", at=(start, 0, 0), axis=(1, 0, 0), radius=d / 2, length=3)]
            sizes.diameters[d] += 1
            sizes.texts.append(3)
    key, i = lot.choice(("key", "flat", "both flats", "none")), lot.randrange(count)
    r, begin = radii[i], sum(lengths[:i])
    if key == "key":
        wide, deep, long = lot.choice((5, 6, 8)), lot.choice((3, 4)), lot.randrange(10, 16)
        steps.append(cut("slot", at=(begin + 8, 0, r - deep), size=(long, wide / 2, deep + 1)))
        sizes.either += [(wide,), (long, long + wide), (deep, 2 * r - deep, r - deep)]
        sizes.soft_radii.add(wide / 2)
    if "flat" in key:
        off, long = r - lot.choice((2, 3)), lot.randrange(9, 15)
        for side in (1, -1)[: 1 + (key == "both flats")]:
            steps.append(cut("box", **square(begin + 8, -r - 1, off if side > 0 else -r - 1, long, 2 * r + 2, r + 1 - off)))
        sizes.either += [(long,), (2 * off,) if key == "both flats" else (r + off, off, r - off)]
    end = lot.choice(("hexagon", "chamfer", "bore", "none"))
    if end == "hexagon":
        across = lot.choice((13, 16, 17))
        angles = [math.radians(60 * k) for k in range(6)]
        corner = [(0, across / math.sqrt(3) * math.cos(a), across / math.sqrt(3) * math.sin(a)) for a in angles]
        steps.append(add("prism", at=(at, 0, 0), points=corner, axis=(12, 0, 0)))
        sizes.texts += [across, at + 12]
    else:
        sizes.texts.append(at)
    if end == "chamfer":
        size = lot.choice((1, 1.5, 2))
        r = radii[-1]
        steps += [cut("cylinder", at=(at - size, 0, 0), axis=(1, 0, 0), radius=r + 1, length=size + 1),
                  add("cone", at=(at - size, 0, 0), axis=(1, 0, 0), radius=r, end=r - size, length=size)]
        sizes.either.append((size,))
    if end == "bore":
        d, depth = sizes.new(6, 10, used), lot.randrange(15, 25)
        used.append(d)
        steps.append(cut("cylinder", at=(at + 1, 0, 0), axis=(-1, 0, 0), radius=d / 2, length=depth + 1))
        sizes.diameters[d] += 1
        sizes.texts.append(depth)
    return steps, sizes


def clevis(lot):
    """Lugs with one bore through all of them, a base with holes, and a rib between."""
    sizes = Sizes(lot)
    length, width, base = lot.randrange(60, 90), lot.randrange(60, 80), lot.randrange(10, 16)
    lug, rise, deep = lot.randrange(9, 14), lot.randrange(34, 50), lot.randrange(24, 34)
    steps = [add("box", size=(length, width, base))]
    d, high = sizes.new(8, 14, ()), base + rise - 14
    for y in (0, width - lug):
        is_round = lot.randrange(2) == 0
        steps.append(add("box", **square(10, y, 0, deep, lug, high if is_round else base + rise)))
        if is_round:
            steps.append(add("cylinder", at=(10 + deep / 2, y, high), axis=(0, 1, 0), radius=deep / 2, length=lug))
    steps.append(cut("cylinder", at=(10 + deep / 2, -1, high), axis=(0, 1, 0), radius=d / 2, length=width + 2))
    sizes.texts += [length, width, base, lug]
    sizes.bores[d] += 2
    sizes.soft_radii.add(deep / 2)
    other = sizes.new(5, 7, (d,), 0.5)
    for y in lot.choice(((width / 2,), (12, width - 12))):
        steps.append(cut("cylinder", at=(length - 9, y, -1), radius=other / 2, length=base + 2))
        sizes.diameters[other] += 1
    if lot.randrange(2):
        steps.append(add("box", **square(10 + deep / 2 - 3, lug - 1, base - 1, 6, width - 2 * lug + 2, 7)))
        sizes.texts.append(6)
    return steps, sizes


FAMILIES = (plate, turned, bracket, milled, wedge, shaft, clevis)


def words(pdf, folder):
    """[(text, box)] of all words, in points; y points down."""
    page = subprocess.run(["pdftotext", "-raw", "-bbox", pdf, "-"], capture_output=True, check=True, cwd=folder).stdout
    found = []
    for word in ElementTree.fromstring(page).iter("{http://www.w3.org/1999/xhtml}word"):
        left, top, right, bottom = (float(word.get(key)) for key in ("xMin", "yMin", "xMax", "yMax"))
        # Poppler's boxes reach from the highest ascender of the font to its lowest descender; digits take half of that.
        found.append((word.text, (left, top + (bottom - top) / 4, right, bottom - (bottom - top) / 4)))
    return joined(found)


def joined(found):
    """Poppler takes an inclined text letter by letter: joins the signs of a size."""
    result = []
    for text, box in found:
        if result and re.fullmatch(r"[⌀R]?[\d.]*", result[-1][0]) and re.fullmatch(r"[\d.]+°?|[°×]", text):
            before = result[-1][1]
            right, down = ((box[i] + box[i + 2] - before[i] - before[i + 2]) / 2 for i in (0, 1))
            if min(abs(right), abs(down)) > 0.3 and math.hypot(right, down) < 14:
                result[-1] = (result[-1][0] + text, box)
                continue
        result.append((text, box))
    return result


def overlaps(a, b):
    """How much of the smaller box is under the other one."""
    across = min(a[2], b[2]) - max(a[0], b[0])
    down = min(a[3], b[3]) - max(a[1], b[1])
    area = min((box[2] - box[0]) * (box[3] - box[1]) for box in (a, b))
    return 0 if across <= 0 or down <= 0 or area <= 0 else across * down / area


def number(value):
    return f"{value:g}"


def read_sheet(found):
    """Diameters and radii with their multiplicities, and all numbers."""
    diameters, radii, numbers = collections.Counter(), collections.Counter(), set()
    times, follows_count = 1, False
    for text, _ in found:
        many = re.fullmatch(r"\(?(\d+)[×x]", text)
        if many:
            times = int(many[1])
        elif not re.match(r"[⌴⌵↧]", text) and not follows_count:
            times = 1
        follows_count = bool(many)
        for kind, digits in re.findall(r"(⌀|R)(\d+(?:\.\d+)?)", text):
            (diameters if kind == "⌀" else radii)[float(digits)] += times
        numbers.update(float(digits) for digits in re.findall(r"\d+(?:\.\d+)?", text))
    return diameters, radii, numbers


def strokes(pdf, folder):
    """Straight stretches of all stroked paths, in points; y points down."""
    svg = Path(folder) / (Path(pdf).name + ".svg")
    subprocess.run(["pdftocairo", "-svg", pdf, svg], check=True)
    found = []
    for path in ElementTree.parse(svg).iter("{http://www.w3.org/2000/svg}path"):
        style = path.get("style", "") + "".join(f"{key}:{value};" for key, value in path.attrib.items())
        if "stroke-width" not in style or re.search(r"stroke:none", style):
            continue
        turn = [float(v) for v in re.findall(r"[-\d.e]+", path.get("transform", "matrix(1,0,0,1,0,0)").partition("(")[2])]
        place, start = None, None
        for letter, numbers in re.findall(r"([MLCZ])([^MLCZ]*)", path.get("d", "")):
            values = [float(v) for v in numbers.split()]
            x, y = (values[-2:] if values else start)
            point = (turn[0] * x + turn[2] * y + turn[4], turn[1] * x + turn[3] * y + turn[5])
            if letter == "M":
                start = (x, y)
            else:
                found.append((place, point))
            place = point
    svg.unlink()
    return found


def runs_through(stroke, box):
    """Whether a stroke enters the middle of a text: the inner half of its box along both sides."""
    (x, y), (to_x, to_y) = stroke
    wide, high, low, high_end = (box[2] - box[0]) / 4, (box[3] - box[1]) / 4, 0.0, 1.0
    for at, step, left, right in ((x, to_x - x, box[0] + wide, box[2] - wide), (y, to_y - y, box[1] + high, box[3] - high)):
        if abs(step) < 1e-9:
            if not left < at < right:
                return False
            continue
        first, last = sorted(((left - at) / step, (right - at) / step))
        low, high_end = max(low, first), min(high_end, last)
    return low < high_end


def faults_of_sheet(pdf, sizes, folder, page):
    found = words(pdf, folder)
    wrong = []
    for i, (text, box) in enumerate(found):
        if box[0] < 0 or box[1] < 0 or box[2] > page[0] or box[3] > page[1]:
            wrong.append(f"'{text}' is beyond the page")
        wrong += [f"'{text}' lies over '{other}'" for other, there in found[:i] if overlaps(box, there) > 0.15]
    drawn = strokes(pdf, folder)
    wrong += [f"a line runs through '{text}'" for text, box in found if any(runs_through(stroke, box) for stroke in drawn)]
    diameters, radii, numbers = read_sheet(found)
    for d, count in sizes.diameters.items():
        if diameters[d] != count:
            wrong.append(f"{count}× ⌀{number(d)} are noted {diameters[d]} times")
    for d, count in sizes.bores.items():
        if diameters[d] not in (1, count):
            wrong.append(f"⌀{number(d)} of {count} lugs is noted {diameters[d]} times")
    wrong += [f"⌀{number(d)} is noted, and is not there" for d in diameters if d not in sizes.diameters and d not in sizes.bores]
    for r in radii:
        if r not in sizes.radii and r not in sizes.soft_radii:
            wrong.append(f"R{number(r)} is noted, and is not there")
    for r in sizes.radii:
        if r not in radii:
            wrong.append(f"R{number(r)} is missing")
    wrong += [f"{number(value)} is missing" for value in sizes.texts if value not in numbers]
    wrong += [f"none of {', '.join(map(number, values))} is there" for values in sizes.either if not numbers & set(values)]
    return wrong


VIEWS = ("front,top", "front,top,right", "front,top,left,isometric", "front:section={axis}@{at},top,right", "front,top,right,isometric")


def trial(epura, seed, index, part, sizes, folder):
    lot = random.Random(f"views {seed}/{index}")
    views = lot.choice(VIEWS).format(axis="y", at=number(part["middle"]))
    arguments = [part["file"], "--views", views, "--dimensions", lot.choice(("auto", "auto", "hole-table")), "--threads", "1"]
    pdf = part["file"] + ".pdf"
    drawn = subprocess.run([epura, "draw", *arguments, "-o", pdf, "--verify"], capture_output=True, text=True)
    lint = subprocess.run([epura, "lint", *arguments], capture_output=True, text=True)
    wrong = []
    if drawn.returncode not in (0, 1) or not Path(pdf).exists():
        wrong.append(f"draw ended with {drawn.returncode}: {drawn.stderr.strip()[-300:]}")
    else:
        size = subprocess.run(["pdfinfo", pdf], capture_output=True, text=True).stdout
        page = tuple(map(float, re.search(r"Page size:\s+([\d.]+) x ([\d.]+)", size).groups()))
        wrong += faults_of_sheet(pdf, sizes, folder, page)
        if drawn.returncode:
            wrong.append(f"draw says: {drawn.stderr.strip()[-300:]}")
    if lint.returncode:
        wrong.append(f"lint says: {lint.stdout.strip()[:400]}")
    return index, arguments[1:], wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("epura")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", default="epura")
    parser.add_argument("--keep", type=Path, help="a folder for parts and sheets with faults")
    parser.add_argument("--family", type=lambda name: {f.__name__: f for f in FAMILIES}[name], help="parts of one family alone")
    parser.add_argument("--workers", type=int, default=2)
    given = parser.parse_args()
    if given.keep:
        given.keep.mkdir(parents=True, exist_ok=True)
    bad = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(given.workers) as pool:
        maker = subprocess.Popen([sys.executable, "-c", MADE_BY_FREECAD], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                 env={**os.environ, "PYTHONPATH": "/usr/lib/freecad-python3/lib", "QT_QPA_PLATFORM": "offscreen"})
        trials = []
        for index in range(given.first, given.first + given.count):
            lot = random.Random(f"part {given.seed}/{index}")
            steps, sizes = given.family(lot) if given.family else lot.choice(FAMILIES)(lot)
            middle = steps[0]["size"][1] / 2 if "size" in steps[0] else steps[0]["axis"][1] / 2
            part = {"file": f"{folder}/p{index}.step", "steps": steps, "middle": middle}
            maker.stdin.write(json.dumps(part) + "\n")
            maker.stdin.flush()
            if not maker.stdout.readline():
                sys.exit(f"FreeCAD made no part {index}: {json.dumps(steps)}")
            trials.append(pool.submit(trial, given.epura, given.seed, index, part, sizes, folder))
        for done in trials:
            index, arguments, wrong = done.result()
            bad += bool(wrong)
            for line in wrong:
                print(f"p{index} {' '.join(arguments)}: {line}", flush=True)
            for file in Path(folder).glob(f"p{index}.*"):
                if wrong and given.keep:
                    (given.keep / file.name).write_bytes(file.read_bytes())
                file.unlink()
        maker.stdin.close()
    print(f"{bad} of {given.count} sheets show a fault")
    sys.exit(bad > 0)


if __name__ == "__main__":
    main()
