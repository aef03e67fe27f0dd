# SPDX-License-Identifier: Apache-2.0
"""Judges what bench/in_memory drew by the faces of the shapes themselves (truth.py), each 200 mm large, and prints who errs.

    python3 memory.py parts FOLDER              writes the parts of parts.py as BREP files
    python3 memory.py judge FOLDER [NUMBER...]  a row for each shape, or those of the numbers, and view
"""

import math
import pathlib
import sys

import numpy
from FreeCAD import Vector  # before its modules
import Part

import parts
import truth
from score import worst

SIZE = 200  # mm of a shape's diagonal
EYES = {"parallel": math.inf, "central": 2 * SIZE}  # mm from the centre, as in bench/in_process.cpp
TOWARDS = (1, -1, 1)
DRAWERS = ("exact", "polygonal", "epura")
FINE = 0.02  # mm between faces and the triangles that hide
LEAST = 0.5  # mm of errors of a view that count, as in table.py


def write_parts(folder):
    for name, make in parts.MADE.items():
        make().exportBrep(f"{folder}/{name}.brep")


def ink_of(file, scale):
    """The visible lines; nothing where there is no drawing."""
    if not file.exists():
        return None
    rows = numpy.loadtxt(file, ndmin=2).reshape(-1, 5)
    return rows[rows[:, 0] == 1, 1:] * scale


def errors_of(ink, view):
    """mm that are seen and not drawn, and that are drawn and not seen, and where most of these lie."""
    rows = {kind: numpy.array(lines, float).reshape(-1, 4) for kind, lines in view.items()}
    return worst(rows["visible"], ink), worst(ink, numpy.concatenate((rows["visible"], rows["smooth_visible"])))


def judge(folder, number, name, tally):
    shape = Part.read(f"{folder}/{number}.brep")
    truth.refuse_touching(shape)
    scale = SIZE / float((folder / f"{number}.size").read_text())
    shape = shape.scaled(scale, Vector())
    known = truth.known_of(shape)
    for kind, eye in EYES.items():
        view = truth.view_of(known, TOWARDS, eye)
        cells = [name, kind, str(len(shape.Faces))]
        for drawer in DRAWERS:
            ink = ink_of(folder / f"{number}-{kind}-{drawer}.txt", scale)
            if ink is None or len(ink) == 0:
                cells += ["nothing", ""]
                tally.setdefault((kind, drawer), []).append(math.inf)
                continue
            (lacks, lacking), (wrong, place) = errors_of(ink, view)
            cells += [f"{lacks:.1f}", f"{wrong:.1f}"]
            tally.setdefault((kind, drawer), []).append(lacks + wrong)
            if lacks + wrong >= LEAST:
                at = place if wrong >= lacks else lacking
                cells[-1] += f" at {at[0]:.0f},{at[1]:.0f}"
        print("| " + " | ".join(cells) + " |", flush=True)


def judge_all(folder, numbers):
    print("| shape | seen | faces | " + " | ".join(f"{drawer}: lacks, mm | has wrong, mm" for drawer in DRAWERS) + " |")
    print("|---" * (3 + 2 * len(DRAWERS)) + "|")
    tally = {}
    for line in (folder / "names.txt").read_text().splitlines():
        number, _, name = line.partition(" ")
        if (not numbers or number in numbers) and (folder / f"{number}.brep").exists():
            try:
                judge(folder, number, name, tally)
            except (ValueError, RuntimeError, Part.OCCError) as error:
                print(f"| {name} | no truth: {error} |", flush=True)
    print("\n| seen | drawn by | views | no drawing | errs | mm of errors |\n|---|---|---|---|---|---|")
    for (kind, drawer), errors in tally.items():
        done = [error for error in errors if error < math.inf]
        print(f"| {kind} | {drawer} | {len(errors)} | {len(errors) - len(done)} | {sum(error >= LEAST for error in done)} | {sum(done):.1f} |")


def main(what, folder, *numbers):
    if what == "parts":
        write_parts(folder)
    else:
        truth.FINE = FINE
        judge_all(pathlib.Path(folder), numbers)


main(*sys.argv[1:])
