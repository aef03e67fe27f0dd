# SPDX-License-Identifier: Apache-2.0
"""Tries the judge on what is known: lengths of lines that follow from the sizes of a part, one drawing in three formats, planted errors.

    python3 check.py FOLDER
"""

import math
import pathlib
import sys

from FreeCAD import Vector  # before its modules
import numpy
import Part

import ink
import programs
import score
import sheets
import truth
from views import VIEWS

SVG = """<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="0 0 200 100" fill="none" stroke="#000" stroke-width=".5">
<g transform="translate(20,20)"><path d="M0 0h80v40h-80z"/><circle cx="40" cy="20" r="10"/></g>
<path stroke-dasharray="4 2" d="M120 20a20 20 0 0 1 40 0"/><g class="hidden"><path d="M120 60L160 60"/></g></svg>"""
DXF = ("0 SECTION 2 ENTITIES 0 LWPOLYLINE 8 0 70 1 10 10 20 40 10 50 20 40 10 50 20 20 10 10 20 20 0 CIRCLE 8 0 10 30 20 30 40 5 "
       "0 ARC 8 0 6 DASHED 10 70 20 40 40 10 50 0 51 180 0 LINE 8 hidden 10 60 20 20 11 80 21 20 0 ENDSEC 0 EOF")
# 100 x 50 mm, in units of a millimetre: the circle as a square on its corner, since PDF has no arcs.
PDF = """q 2.834645669 0 0 2.834645669 0 0 cm 0.25 w 10 20 40 20 re S 25 30 m 30 35 l 35 30 l 30 25 l s [2 1] 0 d 60 20 m 80 20 l S Q"""


def pdf_of(content):
    things = ["<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
              "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 283.4645669 141.7322835] /Contents 4 0 R "
              "/Resources << /Font << /F << /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >> >> >> >>",
              f"<< /Length {len(content)} >>\nstream\n{content}\nendstream"]
    text, places = "%PDF-1.4\n", []
    for i, thing in enumerate(things):
        places.append(len(text))
        text += f"{i + 1} 0 obj\n{thing}\nendobj\n"
    table = "".join(f"{place:010d} 00000 n \n" for place in places)
    return text + f"xref\n0 5\n0000000000 65535 f \n{table}trailer\n<< /Size 5 /Root 1 0 R >>\nstartxref\n{len(text)}\n%%EOF\n"


def expect(what, value, wanted, tolerance):
    if abs(value - wanted) > tolerance:
        sys.exit(f"check: {what} is {value:g} instead of {wanted:g}")


def lengths(shape, view):
    found = truth.view_of(truth.known_of(shape), VIEWS[view])
    return {kind: length_of(numpy.array(rows, float).reshape(-1, 4)) for kind, rows in found.items()}, found


def length_of(lines):
    return float(numpy.linalg.norm(lines[:, 2:] - lines[:, :2], axis=1).sum())


def check_truth():
    block = Part.makeBox(40, 30, 20).cut(Part.makeCylinder(5, 40, Vector(20, 15, -5)))
    front, _ = lengths(block, "front")
    expect("the visible length of a bored block from the front", front["visible"], 120, 0.1)
    expect("the hidden length of its bore", front["hidden"], 40, 0.1)
    top, _ = lengths(block, "top")
    expect("the visible length from the top", top["visible"], 140 + 10 * math.pi, 0.1)
    ball, _ = lengths(Part.makeSphere(10), "isometric")
    expect("the outline of a sphere", ball["visible"], 20 * math.pi, 0.2)
    expect("its hidden length", ball["hidden"], 0, 0)
    check_central()
    block = Part.makeBox(40, 30, 20)
    smooth, _ = lengths(block.makeFillet(5, [edge for edge in block.Edges if edge.BoundBox.ZLength > 1][:1]), "isometric")
    # Both stand on the same line of the paper, one 10 / sqrt(6) above the other.
    expect("the length of the edges of a fillet", smooth["smooth_visible"] + smooth["smooth_hidden"], 20 * math.sqrt(2 / 3) + 10 / math.sqrt(6), 0.1)


def check_central():
    """A ball and a cube before the eye: by similar triangles, and by the tangents that an eye has on a ball."""
    eye = 60
    seen = lambda shape, towards: truth.view_of(truth.known_of(shape), towards, eye)
    length = lambda rows: length_of(numpy.array(rows, float).reshape(-1, 4))
    ball = seen(Part.makeSphere(10), VIEWS["isometric"])
    expect("the outline of a sphere from a point", length(ball["visible"]), 2 * math.pi * 10 * eye / math.sqrt(eye ** 2 - 100), 0.2)
    cube = seen(Part.makeBox(20, 20, 20, Vector(-10, -10, -10)), VIEWS["top"])
    expect("the visible length of a cube from a point", length(cube["visible"]), 80 * eye / (eye - 10), 0.1)
    near, far = 10 * eye / (eye - 10), 10 * eye / (eye + 10)
    expect("its hidden length", length(cube["hidden"]), 8 * far + 4 * math.sqrt(2) * (near - far), 0.1)


def check_readers(folder):
    drawings = {"svg": (SVG, 120 + 10 * math.pi, 20 + 10 * math.pi), "dxf": ("\n".join(DXF.split()) + "\n", 120 + 10 * math.pi, 20 + 10 * math.pi),
                "pdf": (pdf_of(PDF), 120 + 4 * math.hypot(5, 5), 20)}
    for ending, (text, seen, hidden) in drawings.items():
        name = folder / f"check.{ending}"
        name.write_text(text)
        for what, lines, length in zip(("visible", "hidden"), ink.read(name), (seen, hidden)):
            expect(f"the {what} ink of {ending}", length_of(lines), length, 0.1)


def check_score():
    _, wanted = lengths(Part.makeBox(40, 30, 20).cut(Part.makeCylinder(5, 40, Vector(20, 15, -5))), "front")
    lines = [numpy.array(wanted[kind]) for kind in ("visible", "hidden")]
    moved = [rows + (7, -3, 7, -3) for rows in lines]
    whole = score.score(moved, wanted)
    for name in ("recall", "precision", "recall_hidden", "precision_hidden"):
        expect(name + " of the truth itself", getattr(whole, name), 1, 1e-9)
    expect("its loose ends", whole.loose_ends, 0, 0)
    without = score.score([moved[0], moved[1][:0]], wanted)
    expect("the hidden recall without hidden lines", without.recall_hidden, 0.4 / 20, 0.02)
    more = numpy.concatenate((moved[0], numpy.array([[12, 7, 22, 7]])))
    planted = score.score([more, moved[1]], wanted)
    expect("the length of a line too much", planted.errors["wrong"][0], 10, 0.5)
    expect("its loose ends", planted.loose_ends, 2, 0)
    lost = moved[0][numpy.abs(moved[0][:, 1] - moved[0][:, 1].min()) + numpy.abs(moved[0][:, 3] - moved[0][:, 1].min()) > 1e-6]
    expect("the length of a lost side", score.score([lost, moved[1]], wanted).errors["missing"][0], 40 - 2 * score.BESIDE, 0.5)


def check_sheets(folder):
    """A sheet of a bored block that says all, and what is planted on it."""
    sizes = sheets.sizes_of(Part.makeBox(40, 33, 18).cut(Part.makeCylinder(5, 40, Vector(15, 12, -5))))

    def judged(words, lines="", height=10):
        name = folder / "sheet.pdf"
        texts = "".join(f"BT /F {height} Tf 1 0 0 1 {70 + 40 * (i % 5)} {95 - 30 * (i // 5)} Tm ({word}) Tj ET " for i, word in enumerate(words))
        name.write_bytes(pdf_of(texts + lines).encode("latin-1"))
        return sheets.judge(name, sizes)

    right = ["40", "33", "18", "\u00d810", "12", "15"]
    whole = judged(right)
    expect("the number of sizes of a bored block", whole.needed, 6, 0)
    expect("what a whole sheet lacks", len(whole.missing + whole.false + whole.overlaps + whole.crossed + whole.small), 0, 0)
    expect("what is missing without a place", len(judged(right[:5]).missing), 1, 0)
    expect("what is missing without the bore", len(judged(right[:3] + right[4:]).missing), 1, 0)
    wrong = judged(["41", *right[1:]])
    expect("what is false of 41 for 40", len(wrong.false), 1, 0)
    expect("what is then missing", len(wrong.missing), 1, 0)
    expect("sizes that a line runs through", len(judged(right, "1 w 60 99 m 90 99 l S").crossed), 1, 0)
    expect("sizes beside a line", len(judged(right, "1 w 60 92 m 90 92 l S").crossed), 0, 0)
    expect("words over each other", len(judged(right, "BT /F 10 Tf 1 0 0 1 74 95 Tm (30) Tj ET").overlaps), 1, 0)
    expect("small words", len(judged(right, height=6).small), 6, 0)


def check_limit():
    """The limit is on work, not on waiting as on a busy machine, but a program that waits for ever is ended, too."""
    programs.measure(["sleep", "1.5"], 1)
    usual, programs.WAITING = programs.WAITING, 0.5
    try:
        programs.measure(["sleep", "60"], 1)
        sys.exit("check: a program that waits for ever is not ended")
    except programs.Refusal:
        programs.WAITING = usual
    try:
        programs.measure(["python3", "-c", "while True: pass"], 1)
    except programs.Refusal as refusal:
        if "processor time" in str(refusal):
            return
    sys.exit("check: a program that works for ever is not ended at the limit")


def check_bodies():
    """Bores one above the other, as one compound, leave two discs between them: no body."""
    touching = Part.makeCompound([Part.makeCylinder(5, 10, Vector(20, 15, z)) for z in (0, 10)])
    try:
        truth.refuse_touching(Part.makeBox(40, 30, 20).cut(touching))
    except ValueError:
        truth.refuse_touching(Part.makeBox(40, 30, 20).cut(touching.Solids))
        return
    sys.exit("check: a body whose faces lie on each other is not refused")


folder = pathlib.Path(sys.argv[1])
check_limit()
check_bodies()
check_truth()
check_readers(folder)
check_score()
check_sheets(folder)
