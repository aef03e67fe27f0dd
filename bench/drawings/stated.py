# SPDX-License-Identifier: Apache-2.0
"""How far epura's lines are from those of the part, both ways, beside the error that each drawing states.

    bench/drawings/stated [--view PROJECTION] [--size MM] [PART|FILE.step...]

Measured is the Hausdorff distance that docs/accuracy.md defines: the larger of the largest distance of visible ink from the visible lines of the
part, and of these from visible ink. The lines are those of truth.py, but with ends where visibility changes found by bisection. Where the part itself
leaves open whether a line is seen, ink may be there or not: so what is measured is never too much by that, and a ratio never too good.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy
from FreeCAD import Vector  # before its modules
import Part

import parts
import truth
from score import near

# Of the diagonal of the part, which is as long as --size on paper, or of a drawing's.
SURFACE = 1e-4  # between the faces and the triangles that hide
CHORD = 1e-5  # between edges and their chords
PIECE = 2e-3  # between places that are tested along a line
ASIDE = 1e-4  # from a line to the rays beside it
NEARER = 1e-3  # nearer to the viewer is in front for certain: more than faces of 84 degrees rise over ASIDE
BEHIND = 3e-4  # nearer by less is not in front for certain: three times SURFACE
END = 3e-4  # by which lines may be seen farther, or less far for certain, than triangles tell: those are off by a third of that across the line
HALVINGS = 8  # of a piece in which visibility changes
INK_STEP = 5e-4  # between places that are tested along ink
ROUND = 0.02  # radians by which the normal turns over a tenth of the size of a face; less may be the cusp of a contour
GRID = 72  # cells of a face along u and v: outlines lie on the surface at their sides, and off the sight by the square of what they bend in
# between. Of thin tori, with a third as many, cusps were 0.8 mm off.
FIRST = 1e-5  # of distances, which grow by FACTOR
FACTOR = 3
FEW = 400  # places whose distances are computed one by one


class Visibility:
    """Which places of lines are seen, for certain or perhaps."""

    def __init__(self, shape, viewer, size):
        self.size = size
        self.hiding = truth.Hiding(truth.facets_of(shape), viewer)

    def nearest(self, places, along):
        aside = numpy.stack((-along[:, 1], along[:, 0]), 1) * ASIDE * self.size
        depth = self.hiding.depth(numpy.concatenate((places[:, :2] + aside, places[:, :2] - aside)))
        return depth.reshape(2, -1).min(0) - places[:, 2]

    def spans(self, pieces, certain):
        """What may be seen of the first pieces, and for certain of those from number `certain` on, as rows of two ends in space; and from which piece
        each is."""
        limits = numpy.where(numpy.arange(len(pieces)) < certain, NEARER, BEHIND) * self.size
        along = pieces[:, 1, :2] - pieces[:, 0, :2]
        length = numpy.linalg.norm(along, axis=1)
        number = numpy.nonzero(length > 1e-9 * self.size)[0]  # others are seen end-on
        pieces, along, limits = pieces[number], (along / numpy.maximum(length, 1e-300)[:, None])[number], limits[number]
        both = self.nearest(pieces.transpose(1, 0, 2).reshape(-1, 3), numpy.tile(along, (2, 1))).reshape(2, -1)
        first, last = both <= limits
        whole, part = first & last, numpy.nonzero(first != last)[0]
        low, high = numpy.zeros(len(part)), numpy.ones(len(part))
        start, way = pieces[part, 0], pieces[part, 1] - pieces[part, 0]
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            as_first = (self.nearest(start + way * middle[:, None], along[part]) <= limits[part]) == first[part]
            low, high = numpy.where(as_first, middle, low), numpy.where(as_first, high, middle)
        farther = numpy.where(number[part] < certain, 1, -1) * numpy.where(first[part], 1, -1) * END * self.size
        ends = numpy.clip(low + farther / numpy.linalg.norm(way, axis=1), 0, 1)
        change, from_first = start + way * ends[:, None], first[part, None]
        ends = numpy.stack((numpy.where(from_first, start, change), numpy.where(from_first, change, start + way)), 1)
        return numpy.concatenate((pieces[whole], ends)), numpy.concatenate((number[whole], number[part]))


def pieces_of(polyline, longest):
    counts = numpy.maximum(1, numpy.ceil(numpy.linalg.norm(numpy.diff(polyline, axis=0), axis=1) / longest).astype(int))
    rows = []
    for a, b, count in zip(polyline, polyline[1:], counts):
        ends = a + (b - a) * numpy.arange(count + 1)[:, None] / count
        rows.append(numpy.stack((ends[:-1], ends[1:]), 1))
    return numpy.concatenate(rows) if rows else numpy.empty((0, 2, 3))


def turning(face, u, v, towards):
    """By how much the normal turns to the viewer along the sight, over a tenth of the face: below 0, the face hides its own contour."""
    su, sv = (numpy.array(d) for d in face.derivative1At(u, v))
    (a, b), *_ = numpy.linalg.lstsq(numpy.stack((su, sv), 1), numpy.array(towards), rcond=None)
    step = 1e-4 * face.BoundBox.DiagonalLength
    normals = [face.normalAt(u + sign * step * a, v + sign * step * b) for sign in (1, -1)]
    return (normals[0].dot(towards) - normals[1].dot(towards)) / (2 * step) * face.BoundBox.DiagonalLength / 10


def outlines_of(shape, viewer, longest):
    """Pieces of contours that may be seen, and those of them of which it is certain that their own face does not hide them."""
    towards, solid = Vector(*viewer.axes[2]), len(shape.Solids) > 0
    may, must = [numpy.empty((0, 2, 3))], [numpy.empty((0, 2, 3))]
    for face, *grid in truth.normals_of(shape):
        for segment in truth.outline_of(face, *grid, viewer):
            middle = Vector(*segment.mean(0))
            turn = turning(face, *face.Surface.parameter(middle), towards) if solid else 1
            if turn < -ROUND:
                continue
            pieces = pieces_of(viewer.sees(segment), longest)
            may.append(pieces)
            if turn > ROUND:
                must.append(pieces)
    return numpy.concatenate(may), numpy.concatenate(must)


def lines_of(shape, viewer):
    """Segments across the sight that may be seen, and those that are seen for certain."""
    size = shape.BoundBox.DiagonalLength
    truth.FINE = SURFACE * size
    sight = Visibility(shape, viewer, size)
    truth.FINE = CHORD * size
    may, must = outlines_of(shape, viewer, PIECE * size)
    edges = [(pieces_of(viewer.sees(polyline), PIECE * size), sharp) for polyline, sharp in truth.edges_of(shape)]
    may = numpy.concatenate([may, *(pieces for pieces, _ in edges)])
    must = numpy.concatenate([must, *(pieces for pieces, sharp in edges if sharp)])
    seen, number = sight.spans(numpy.concatenate((may, must)), len(may))
    return tuple(seen[chosen][:, :, :2].reshape(-1, 4) for chosen in (number < len(may), number >= len(may)))


def farthest(points, lines, size):
    """The largest distance of a point from the nearest line, and that point."""
    if len(points) == 0 or len(lines) == 0:
        return (0.0 if len(points) == 0 else numpy.inf), None
    distance, left = FIRST * size, points
    while True:
        far = left[~near(left, lines, distance)]
        if len(far) == 0 or len(left) <= FEW:
            break
        left, distance = far, distance * FACTOR
    from_, along = lines[:, :2], lines[:, 2:] - lines[:, :2]
    square = numpy.maximum((along * along).sum(1), 1e-300)
    values = []
    for point in left:
        share = numpy.clip(((point - from_) * along).sum(1) / square, 0, 1)
        values.append(numpy.linalg.norm(point - from_ - share[:, None] * along, axis=1).min())
    return float(numpy.max(values)), left[int(numpy.argmax(values))]


def places_of(lines, step):
    count = numpy.maximum(1, numpy.ceil(numpy.linalg.norm(lines[:, 2:] - lines[:, :2], axis=1) / step).astype(int))
    row = numpy.repeat(numpy.arange(len(lines)), count + 1)
    nth = numpy.arange(len(row)) - numpy.repeat(numpy.cumsum(count + 1) - count - 1, count + 1)
    share = (nth / count[row])[:, None]
    return lines[row, :2] * (1 - share) + lines[row, 2:] * share


def draw(file, view, scale, folder):
    """The view of epura's JSON, with its stated error."""
    output = folder / "drawing.json"
    subprocess.run([os.environ["EPURA"], "draw", file, "--projection", view, "--hidden", "none", "--sheet", "none", "--scale", f"{scale!r}:1",
                    "-o", output], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    drawing = json.loads(output.read_text())
    return drawing["views"][0], drawing["report"]["error"][0]


def measure(lines, view, size, scale):
    """Of ink from the lines that may be there, and of the lines that must be there from ink, on paper."""
    ink = numpy.array([segment["from"] + segment["to"] for segment in view["segments"] if segment["visible"]], float)
    may, must = lines
    paper = size * scale
    to_truth, at_ink = farthest(places_of(ink, INK_STEP * paper), may, paper)
    to_ink, at_line = farthest(must.reshape(-1, 2), ink, paper)
    return to_truth, to_ink, at_ink if to_truth > to_ink else at_line


def on_page(lines, axes, view):
    """From the plane across the sight to the page."""
    matrix = numpy.array(view["world_to_page"]).reshape(4, 4)
    to_world = numpy.linalg.inv(axes)[:, :2]  # of what lies in the plane through the origin
    def move(points):
        mapped = numpy.concatenate((points @ to_world.T, numpy.ones((len(points), 1))), 1) @ matrix.T
        return mapped[:, :2] / mapped[:, 3:]
    return tuple(move(rows.reshape(-1, 2)).reshape(-1, 4) for rows in lines)


def rows_of(name, options, folder):
    shape = parts.MADE[name]() if name in parts.MADE else Part.read(name)
    path = folder / pathlib.Path(name).stem
    shape.exportStep(f"{path}.step")
    made = Part.read(f"{path}.step")
    size = made.BoundBox.DiagonalLength
    made.exportStl(f"{path}.stl", size / truth.USUAL_FINENESS)
    scale, viewer = options.size / size, truth.Viewer(options.direction)
    lines = lines_of(made, viewer)
    files = {"STEP": f"{path}.step" if name in parts.MADE else name}
    if name in parts.MADE:
        files["STL"] = f"{path}.stl"
    for kind, file in files.items():
        view, stated = draw(file, options.view, scale, folder)
        yield kind, stated, measure(on_page(lines, viewer.axes, view), view, size, scale)


def main():
    truth.GRID = GRID
    parser = argparse.ArgumentParser(prog="bench/drawings/stated", description="The stated errors of drawings beside measured ones.")
    parser.add_argument("--view", default="isometric", help="a projection that is parallel and at right angles")
    parser.add_argument("--direction", default="1,-1,1", help="towards its viewer")
    parser.add_argument("--size", type=float, default=200, help="of the part's diagonal on paper, mm")
    parser.add_argument("--least", type=float, default=0.02, help="mm on paper below which measured errors are those of the measure")
    parser.add_argument("parts", nargs="*", help="parts of parts.py, or STEP files; all of parts.py")
    options = parser.parse_args()
    options.direction = [float(value) for value in options.direction.split(",")]
    print("| part | of | stated | by | ink from lines | lines from ink | ratio | at |\n|---|---|---|---|---|---|---|---|", flush=True)
    ratios, too_little = [], 0
    with tempfile.TemporaryDirectory() as folder:
        for name in options.parts or parts.MADE:
            try:
                for kind, stated, (to_truth, to_ink, at) in rows_of(name, options, pathlib.Path(folder)):
                    ratios.append(stated["total"] / max(to_truth, to_ink, options.least))
                    too_little += max(to_truth, to_ink) > stated["total"] + options.least
                    place = "" if at is None else "%.1f,%.1f" % tuple(at)
                    print(f"| {pathlib.Path(name).stem} | {kind} | {stated['total']:.3f} | {stated['dominant']} | {to_truth:.4f} | {to_ink:.4f} "
                          f"| {ratios[-1]:.1f} | {place} |", flush=True)
            except (ValueError, subprocess.CalledProcessError, RuntimeError) as error:
                print(f"{name}: {error}", file=sys.stderr, flush=True)
    few = sum(ratio <= 5 for ratio in ratios)
    print(f"\nOf {len(ratios)} drawings, {few} state at most 5 times what is measured, and {too_little} less than is measured.")


if __name__ == "__main__":
    main()
