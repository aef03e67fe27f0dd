# SPDX-License-Identifier: Apache-2.0
"""What a drawing of a part should show, from its faces and edges themselves, without anybody's hidden-line removal.

    python3 truth.py FOLDER [NAME | FILE.step]...     writes NAME.json, NAME.step, NAME.stl, NAME-half.step and NAME-half.stl into it

Edges are those where faces meet at more than 5 degrees. Outlines are found here: where the normal of the exact surface turns from the
viewer, by bisection. A piece of a line is visible if beside it, on either side, nothing lies nearer to the viewer; for that, rays go
through triangles within 0.005 mm of the faces. Edges between tangent faces may be drawn or not.

The file has, for each view, segments x0 y0 x1 y1 in mm, x to the right, y up, the origin of the part at 0 0, in the lists `visible`,
`hidden`, `smooth_visible` and `smooth_hidden`; and in `cut` where the plane of the section meets the axis y. A section is the view from the
front of the half behind the plane; its hidden lines may be drawn or not.
"""

import json
import math
import pathlib
import sys

import numpy
from FreeCAD import Vector  # before its modules
import Part

import parts
from score import near
from views import VIEWS, axes_of

TANGENT = math.radians(5)  # exporters are not precise, as in bench/parts
PIECE = 0.5  # mm, of which each is visible or hidden as a whole
FINE = 0.005  # mm between the faces and the triangles that hide
ASIDE = 0.01  # mm from a line to the rays beside it
NEARER = 0.1  # mm nearer to the viewer is in front: more than faces of 84 degrees rise over ASIDE, and than FINE
SAME = 0.02  # mm between lines that are one
POINTS_AT_ONCE = 4000  # at each of which some triangles are tried
CELLS_OF_LARGE = 16  # over as many cells of the page, a triangle is tried at all points near it instead
GRID = 64  # cells of a face along u and v, in each of which an outline is straight
USUAL_FINENESS = 1500  # diagonal / deflection of the STL file, as in bench/parts


class Viewer:
    """Looks from a direction, or from the point in it that is `eye` mm away from the origin, onto the plane through that."""

    def __init__(self, towards, eye=math.inf):
        self.axes, self.eye = axes_of(towards), eye

    def sees(self, points):
        """To the right, up, and nearer to the viewer: straight lines and planes remain what they are."""
        turned = points @ self.axes.T
        return turned / (1 - turned[..., 2:] / self.eye)

    def towards(self, points):
        """The direction to the viewer at each point."""
        return self.axes[2] - points / self.eye


def facets_of(shape):
    """The points of triangles within FINE of the faces, and which three each has."""
    points, triangles = shape.tessellate(FINE)
    return numpy.array([tuple(point) for point in points]), numpy.array(triangles)


class Hiding:
    """The triangles of a part, as the viewer sees them."""

    def __init__(self, facets, viewer):
        points, triangles = facets
        corners = viewer.sees(points)[triangles]
        a, b, c = (corners[:, i, :2] for i in range(3))
        self.area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
        facing = numpy.abs(self.area) > 1e-9
        self.corners, self.area = corners[facing], self.area[facing]
        self.sort_into_cells()

    def sort_into_cells(self):
        """The numbers of the triangles over each cell of the page, one cell after the other."""
        low, high = self.corners[:, :, :2].min(1), self.corners[:, :, :2].max(1)
        self.cells = int(min(256, max(16, len(low) ** 0.5 / 2)))
        self.origin, self.width = low.min(0), (high.max(0) - low.min(0)) / self.cells
        first, last = self.cell_at(low), self.cell_at(high)
        across = last - first + 1
        self.large = numpy.nonzero(across.prod(1) > CELLS_OF_LARGE)[0]
        count = numpy.where(across.prod(1) > CELLS_OF_LARGE, 0, across.prod(1))
        triangle = numpy.repeat(numpy.arange(len(low)), count)
        nth = numpy.arange(len(triangle)) - numpy.repeat(numpy.cumsum(count) - count, count)
        y, x = numpy.divmod(nth, across[triangle, 0])
        cell = (first[triangle, 1] + y) * self.cells + first[triangle, 0] + x
        self.over_cells = triangle[numpy.argsort(cell, kind="stable")]
        self.first_over = numpy.concatenate(([0], numpy.cumsum(numpy.bincount(cell, minlength=self.cells ** 2))))

    def cell_at(self, points):
        return numpy.clip(((points - self.origin) / self.width).astype(int), 0, self.cells - 1)

    def depth(self, points):
        """Of the nearest triangle at each point, -infinity where there is none."""
        nearest = numpy.full(len(points), -numpy.inf)
        order = numpy.argsort(points[:, 0])
        across = points[order, 0]
        low, high = self.corners[self.large, :, :2].min(1), self.corners[self.large, :, :2].max(1)
        firsts, lasts = numpy.searchsorted(across, low[:, 0]), numpy.searchsorted(across, high[:, 0], "right")
        for i in numpy.nonzero(firsts < lasts)[0]:
            at = order[firsts[i]:lasts[i]]
            at = at[(points[at, 1] >= low[i, 1]) & (points[at, 1] <= high[i, 1])]
            inside, z = self.heights(numpy.full(len(at), self.large[i]), points[at])
            nearest[at[inside]] = numpy.maximum(nearest[at[inside]], z)
        for begin in range(0, len(points), POINTS_AT_ONCE):
            part = points[begin:begin + POINTS_AT_ONCE]
            cell = self.cell_at(part) @ (1, self.cells)
            count = self.first_over[cell + 1] - self.first_over[cell]
            point = numpy.repeat(numpy.arange(len(part)), count)
            at = numpy.arange(len(point)) - numpy.repeat(numpy.cumsum(count) - count, count)
            inside, z = self.heights(self.over_cells[self.first_over[cell][point] + at], part[point])
            numpy.maximum.at(nearest, begin + point[inside], z)
        return nearest

    def heights(self, triangles, points):
        """Which of the points lie in their triangles, and how high those do."""
        corners, area = self.corners[triangles], self.area[triangles]
        weights = []
        for k in range(3):
            q, r = corners[:, (k + 1) % 3], corners[:, (k + 2) % 3]
            weights.append(((q[:, 0] - points[:, 0]) * (r[:, 1] - points[:, 1]) - (q[:, 1] - points[:, 1]) * (r[:, 0] - points[:, 0])) / area)
        inside = (weights[0] >= 0) & (weights[1] >= 0) & (weights[2] >= 0)
        return inside, sum(weight * corners[:, k, 2] for k, weight in enumerate(weights))[inside]

    def split(self, lines):
        """The visible and the hidden pieces of each line, rows x0 y0 x1 y1: hidden is what has something in front of both its sides."""
        if not lines:
            return []
        pieces, line = numpy.concatenate(lines), numpy.repeat(numpy.arange(len(lines)), [len(pieces) for pieces in lines])
        length = numpy.linalg.norm(pieces[:, 1, :2] - pieces[:, 0, :2], axis=1)
        pieces, line, length = pieces[length > 1e-6], line[length > 1e-6], length[length > 1e-6]  # others are seen end-on
        middles, along = pieces.mean(1), (pieces[:, 1, :2] - pieces[:, 0, :2]) / length[:, None]
        aside = numpy.stack((-along[:, 1], along[:, 0]), 1) * ASIDE
        nearest = self.depth(numpy.concatenate((middles[:, :2] + aside, middles[:, :2] - aside)))
        hidden = nearest.reshape(2, -1).min(0) > middles[:, 2] + NEARER
        rows = pieces[:, :, :2].reshape(-1, 4)
        return [(rows[~hidden & (line == i)], rows[hidden & (line == i)]) for i in range(len(lines))]


def normal_at(face, point):
    return face.normalAt(*face.Surface.parameter(point))


def edges_of(shape):
    """Pairs of a polyline and whether the edge is sharp. Seams are no edges, nor are lines without a face."""
    faces = {}
    for face in shape.Faces:
        for edge in face.Edges:
            faces.setdefault(edge.hashCode(), []).append((edge, face))
    for edge in shape.Edges:
        around = [face for other, face in faces.get(edge.hashCode(), []) if other.isSame(edge)]
        if not around or edge.Degenerated or edge.Length < 1e-7 or edge.isSeam(around[0]):
            continue
        places = [edge.valueAt(edge.FirstParameter + t * (edge.LastParameter - edge.FirstParameter)) for t in (0.1, 0.3, 0.5, 0.7, 0.9)]
        sharp = len(around) != 2 or any(normal_at(around[0], p).getAngle(normal_at(around[1], p)) > TANGENT for p in places)
        yield numpy.array([tuple(p) for p in edge.discretize(Deflection=FINE)]), sharp


def normals_of(shape):
    """Each curved face with the parameters, points and normals of a grid over it."""
    for face in shape.Faces:
        if not isinstance(face.Surface, Part.Plane):
            u0, u1, v0, v1 = face.ParameterRange
            us, vs = numpy.linspace(u0, u1, GRID + 1), numpy.linspace(v0, v1, GRID + 1)
            yield face, us, vs, *(numpy.array([[tuple(at(u, v)) for v in vs] for u in us]) for at in (face.valueAt, face.normalAt))


def outline_of(face, us, vs, points, normals, viewer):
    """Segments in space where a curved face turns from the viewer."""
    values = (normals * viewer.towards(points)).sum(2)
    positive = values > 1e-9
    crossings, direction = {}, Vector(*viewer.axes[2])

    def faces_viewer(u, v):
        return face.normalAt(u, v).dot(direction - face.valueAt(u, v) / viewer.eye) > 0

    def crossing(i, j, k, l):
        key = (i, j, k, l)
        if key not in crossings:
            low, high = ((us[i], vs[j]), (us[k], vs[l]))
            if values[i, j] > values[k, l]:
                low, high = high, low
            for _ in range(40):
                middle = ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2)
                low, high = (low, middle) if faces_viewer(*middle) else (middle, high)
            crossings[key] = low
        return crossings[key]

    for i in range(GRID):
        for j in range(GRID):
            sides = [(i, j, i + 1, j), (i + 1, j, i + 1, j + 1), (i, j + 1, i + 1, j + 1), (i, j, i, j + 1)]
            ends = [crossing(*side) for side in sides if positive[side[0], side[1]] != positive[side[2], side[3]]]
            for (ua, va), (ub, vb) in zip(ends[::2], ends[1::2]):
                for k in range(4):
                    a, b = ((ua + (ub - ua) * t / 4, va + (vb - va) * t / 4) for t in (k, k + 1))
                    if face.isPartOfDomain((a[0] + b[0]) / 2, (a[1] + b[1]) / 2):
                        yield numpy.array([tuple(face.valueAt(*a)), tuple(face.valueAt(*b))])


def pieces_of(polyline):
    """Segments of at most PIECE, as an array of rows of two points."""
    pieces = []
    for a, b in zip(polyline, polyline[1:]):
        count = max(1, math.ceil(numpy.linalg.norm(b - a) / PIECE))
        ends = a + (b - a) * numpy.arange(count + 1)[:, None] / count
        pieces.extend(zip(ends, ends[1:]))
    return numpy.array(pieces).reshape(-1, 2, 3)


def known_of(shape):
    """What all views of a shape begin with."""
    return shape, list(normals_of(shape)), facets_of(shape)


def view_of(known, towards, eye=math.inf):
    (shape, curved, facets), viewer = known, Viewer(towards, eye)
    hiding = Hiding(facets, viewer)
    lines = {"sharp": [], "smooth": []}
    for polyline, sharp in edges_of(shape):
        lines["sharp" if sharp else "smooth"].append(pieces_of(viewer.sees(polyline)))
    for face in curved:
        segments = [pieces_of(viewer.sees(segment)) for segment in outline_of(*face, viewer)]
        if segments:
            lines["sharp"].append(numpy.concatenate(segments))
    view = {}
    for kind, prefix in (("sharp", ""), ("smooth", "smooth_")):
        view[prefix + "visible"], view[prefix + "hidden"] = once(hiding.split(lines[kind]))
    return view


def once(lines):
    """The visible and the hidden pieces of lines, without those behind which, or before which, the same line was found already."""
    kept, result = numpy.empty((0, 4)), []
    for kind in (0, 1):
        count = len(kept)
        for line in lines:
            pieces = line[kind]
            points = numpy.concatenate((pieces[:, :2], (pieces[:, :2] + pieces[:, 2:]) / 2, pieces[:, 2:]))
            kept = numpy.concatenate((kept, pieces[~near(points, kept, SAME).reshape(3, -1).all(0)]))
        result.append(numpy.round(kept[count:], 5).tolist())
    return result


def half_of(shape, cut):
    """What lies behind the plane of the section."""
    space = shape.BoundBox
    margin = Vector(1, 1, 1)
    low, high = Vector(space.XMin, cut, space.ZMin), Vector(space.XMax, space.YMax, space.ZMax)
    size = high - low + 2 * margin
    behind = Part.makeBox(size.x, size.y, size.z, low - Vector(1, 0, 1))
    return Part.makeCompound([solid.common(behind) for solid in shape.Solids])  # those that touch are not cut as one


def refuse_touching(shape):
    """A body whose faces lie on each other has no inside there, and no drawing is right or wrong."""
    for solid in shape.Solids:
        try:
            solid.check(True)
        except ValueError as error:  # of other kinds, as where a curve lies 1e-6 mm beside its surface, no drawing tells
            if "SelfIntersect" in str(error):
                raise ValueError("faces of the part lie on each other or cross") from error


def write(shape, path):
    """As STEP and STL; gives back what others read from the STEP file."""
    refuse_touching(shape)
    shape.exportStep(f"{path}.step")
    Part.read(f"{path}.step").exportStl(f"{path}.stl", shape.BoundBox.DiagonalLength / USUAL_FINENESS)
    return Part.read(f"{path}.step")


def main(folder, *names):
    folder = pathlib.Path(folder)
    for name in names or parts.MADE:
        shape = parts.MADE[name]() if name in parts.MADE else Part.read(name)
        path = folder / pathlib.Path(name).stem
        shape = write(shape, path)
        cut = shape.BoundBox.Center.y
        half = write(half_of(shape, cut), f"{path}-half")
        known = known_of(shape)
        truth = {view: view_of(known, viewer) for view, viewer in VIEWS.items() if view != "section"}
        section = truth["section"] = view_of(known_of(half), VIEWS["section"])
        section["smooth_hidden"] += section["hidden"]
        section["hidden"] = []
        pathlib.Path(f"{path}.json").write_text(json.dumps({"cut": cut, "views": truth}))
        print(path.name, *(f"{view} {sum(map(len, lines.values()))}" for view, lines in truth.items()), file=sys.stderr, flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
