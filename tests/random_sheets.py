#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sheets of random parts, read as a checker reads them:  tests/random_sheets.py EPURA [--count N] [--first N] [--keep FOLDER]

FreeCAD (Debian) makes plates, brackets and turned parts whose sizes are known here; epura draws them with automatic dimensions, sections and
hole tables; poppler reads the PDF. On each sheet no text lies over another one or beyond the page, each diameter is noted as often
as the part has it, radii, chamfers, depths and overall sizes are there, and no ⌀ is there that the part lacks. `epura lint` finds
nothing that is free, `--verify` no line that is wrong. A part is drawn from the seed and its number alone.
"""
import argparse
import collections
import concurrent.futures
import json
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


def words(pdf, folder):
    """[(text, box)] of all words, in points; y points down."""
    page = subprocess.run(["pdftotext", "-bbox-layout", pdf, "-"], capture_output=True, check=True, cwd=folder).stdout
    found = []
    for word in ElementTree.fromstring(page).iter("{http://www.w3.org/1999/xhtml}word"):
        left, top, right, bottom = (float(word.get(key)) for key in ("xMin", "yMin", "xMax", "yMax"))
        # Poppler's boxes reach from the highest ascender of the font to its lowest descender; digits take half of that.
        found.append((word.text, (left, top + (bottom - top) / 4, right, bottom - (bottom - top) / 4)))
    return found


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


def faults_of_sheet(pdf, sizes, folder, page):
    found = words(pdf, folder)
    wrong = []
    for i, (text, box) in enumerate(found):
        if box[0] < 0 or box[1] < 0 or box[2] > page[0] or box[3] > page[1]:
            wrong.append(f"'{text}' is beyond the page")
        wrong += [f"'{text}' lies over '{other}'" for other, there in found[:i] if overlaps(box, there) > 0.15]
    diameters, radii, numbers = read_sheet(found)
    for d, count in sizes.diameters.items():
        if diameters[d] != count:
            wrong.append(f"{count}× ⌀{number(d)} are noted {diameters[d]} times")
    wrong += [f"⌀{number(d)} is noted, and is not there" for d in diameters if d not in sizes.diameters]
    for r in sizes.radii:
        if r not in radii:
            wrong.append(f"R{number(r)} is missing")
    wrong += [f"{number(value)} is missing" for value in sizes.texts if value not in numbers]
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
            steps, sizes = lot.choice((plate, turned, bracket))(lot)
            middle = steps[0]["size"][1] / 2 if "size" in steps[0] else 0
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
