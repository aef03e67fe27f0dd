# SPDX-License-Identifier: Apache-2.0
"""Reads the lines of a drawing, SVG, DXF or PDF of any program, as segments in mm with y up.

Dashed lines are hidden ones, as are those in a group, class or layer whose name has "hidden" or "dash". Texts and fills are no lines.
"""

import math
import re
import subprocess
import xml.etree.ElementTree

import numpy

MILLIMETRES = {"mm": 1, "cm": 10, "in": 25.4, "pt": 25.4 / 72, "pc": 25.4 / 6, "px": 25.4 / 96, "": 25.4 / 96}
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
CURVE = 16  # segments of a Bézier curve
ARC = math.radians(3)  # of an arc in a segment
NO_LINES = {"defs", "symbol", "clipPath", "mask", "pattern", "marker", "text", "image", "metadata", "title", "desc", "style"}


class Ink:
    def __init__(self):
        self.visible, self.hidden = [], []

    def add(self, points, hidden):
        (self.hidden if hidden else self.visible).extend((*a[:2], *b[:2]) for a, b in zip(points, points[1:]) if tuple(a) != tuple(b))

    def segments(self):
        return tuple(numpy.array(lines, float).reshape(-1, 4) for lines in (self.visible, self.hidden))


def named_hidden(name):
    return bool(name) and ("hidden" in name.lower() or "dash" in name.lower())


def arc_points(centre, radii, tilt, start, sweep):
    """Of an ellipse; angles in radians, counter-clockwise where y is up."""
    count = max(2, math.ceil(abs(sweep) / ARC) + 1)
    c, s = math.cos(tilt), math.sin(tilt)
    for i in range(count):
        angle = start + sweep * i / (count - 1)
        x, y = radii[0] * math.cos(angle), radii[1] * math.sin(angle)
        yield centre[0] + x * c - y * s, centre[1] + x * s + y * c


# --- SVG

def matrix_of(text):
    whole = numpy.eye(3)
    for name, values in re.findall(r"(\w+)\s*\(([^)]*)\)", text or ""):
        v = [float(value) for value in NUMBER.findall(values)]
        step = numpy.eye(3)
        if name == "matrix":
            step[:2] = numpy.array(v).reshape(3, 2).T
        elif name == "translate":
            step[:2, 2] = v[0], v[1] if len(v) > 1 else 0
        elif name == "scale":
            step[0, 0], step[1, 1] = v[0], v[-1]
        elif name == "rotate":
            c, s = math.cos(math.radians(v[0])), math.sin(math.radians(v[0]))
            step[:2, :2] = (c, -s), (s, c)
            if len(v) == 3:
                step[:2, 2] = numpy.array(v[1:]) - step[:2, :2] @ v[1:]
        else:
            raise ValueError(f"transform '{name}' is not understood")
        whole = whole @ step
    return whole


def elliptic(p, radii, tilt, large, sweep, q):
    """Points of an arc from p to q, after the notes on implementation of SVG."""
    c, s = math.cos(tilt), math.sin(tilt)
    dx, dy = (p[0] - q[0]) / 2, (p[1] - q[1]) / 2
    x, y = c * dx + s * dy, -s * dx + c * dy
    rx, ry = abs(radii[0]), abs(radii[1])
    if rx == 0 or ry == 0 or (x == 0 and y == 0):
        return [p, q]
    grow = math.sqrt(max(1, (x / rx) ** 2 + (y / ry) ** 2))
    rx, ry = rx * grow, ry * grow
    root = math.sqrt(max(0, (rx * ry) ** 2 / ((rx * y) ** 2 + (ry * x) ** 2) - 1)) * (-1 if large == sweep else 1)
    cx, cy = root * rx * y / ry, -root * ry * x / rx
    start, end = math.atan2((y - cy) / ry, (x - cx) / rx), math.atan2((-y - cy) / ry, (-x - cx) / rx)
    turn = (end - start) % (2 * math.pi) - (0 if sweep else 2 * math.pi)
    centre = c * cx - s * cy + (p[0] + q[0]) / 2, s * cx + c * cy + (p[1] + q[1]) / 2
    return list(arc_points(centre, (rx, ry), tilt, start, turn))


def bezier(points):
    rows = numpy.array(points)
    for t in numpy.linspace(0, 1, CURVE + 1)[1:]:
        level = rows
        while len(level) > 1:
            level = level[:-1] * (1 - t) + level[1:] * t
        yield tuple(level[0])


class Path:
    """The polylines of path data."""

    def __init__(self, data):
        self.rest, self.lines, self.at, self.control = data, [], (0.0, 0.0), None
        command = None
        while self.skip():
            if self.rest[0].isalpha():
                command, self.rest = self.rest[0], self.rest[1:]
                if command in "zZ":
                    self.lines[-1].append(self.lines[-1][0])
                    self.at = self.lines[-1][0]
                    continue
            self.step(command)
            command = {"m": "l", "M": "L"}.get(command, command)

    def skip(self):
        self.rest = self.rest.lstrip(" \t\r\n,")
        return self.rest

    def number(self, pattern=NUMBER):
        self.skip()
        found = pattern.match(self.rest)
        self.rest = self.rest[found.end():]
        return float(found[0])

    def point(self, relative):
        x, y = self.number(), self.number()
        return (x + self.at[0], y + self.at[1]) if relative else (x, y)

    def step(self, command):
        relative, kind = command.islower(), command.upper()
        smooth = (2 * self.at[0] - self.control[1][0], 2 * self.at[1] - self.control[1][1]) if self.control else self.at
        last, self.control = self.control, None
        if kind == "M":
            self.at = self.point(relative)
            self.lines.append([self.at])
            return
        if self.lines[-1][-1] != self.at or (len(self.lines[-1]) > 1 and self.lines[-1][0] == self.at):
            self.lines.append([self.at])
        if kind == "L":
            points = [self.point(relative)]
        elif kind == "H":
            points = [(self.number() + (self.at[0] if relative else 0), self.at[1])]
        elif kind == "V":
            points = [(self.at[0], self.number() + (self.at[1] if relative else 0))]
        elif kind == "A":
            flag = re.compile("[01]")
            radii, tilt = (self.number(), self.number()), math.radians(self.number())
            large, sweep = self.number(flag), self.number(flag)
            points = elliptic(self.at, radii, tilt, large, sweep, self.point(relative))[1:]
        else:
            count = {"C": 3, "S": 2, "Q": 2, "T": 1}[kind]
            controls = [self.point(relative) for _ in range(count)]
            if kind in "ST":
                controls.insert(0, smooth if last and last[0] == {"S": 3, "T": 2}[kind] else self.at)
            self.control = (len(controls), controls[-2])
            points = list(bezier([self.at, *controls]))
        self.lines[-1].extend(points)
        self.at = points[-1]


def shape_lines(kind, item):
    get = lambda name: float(NUMBER.match(item.get(name, "0").strip())[0])
    if kind == "path":
        return Path(item.get("d", "")).lines
    if kind == "line":
        return [[(get("x1"), get("y1")), (get("x2"), get("y2"))]]
    if kind in ("polyline", "polygon"):
        numbers = [float(number) for number in NUMBER.findall(item.get("points", ""))]
        points = list(zip(numbers[::2], numbers[1::2]))
        return [points + points[:1] if kind == "polygon" else points]
    if kind in ("circle", "ellipse"):
        radii = (get("r"), get("r")) if kind == "circle" else (get("rx"), get("ry"))
        return [list(arc_points((get("cx"), get("cy")), radii, 0, 0, 2 * math.pi))]
    if kind == "rect":
        x, y, w, h = map(get, ("x", "y", "width", "height"))
        return [[(x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y)]]
    return []


def read_svg(text):
    root = xml.etree.ElementTree.fromstring(text)
    ink, names = Ink(), {}
    rules = {name: body for item in root.iter() if item.tag.endswith("}style") and item.text
             for name, body in re.findall(r"\.([\w-]+)\s*\{([^}]*)\}", item.text)}
    for item in root.iter():
        names[item.get("id")] = item
    length = re.match(r"([\d.eE+-]+)\s*(\w*)", root.get("width", ""))
    box = [float(number) for number in NUMBER.findall(root.get("viewBox", ""))]
    unit = MILLIMETRES[length[2]] if length else MILLIMETRES["px"]
    scale = float(length[1]) * unit / box[2] if length and box else unit
    flip = numpy.diag([scale, -scale, 1.0])

    def visit(item, matrix, style):
        kind = item.tag.rpartition("}")[2]
        if kind in NO_LINES:
            return
        style = dict(style)
        words = [item.get("id"), item.get("class"), *(value for name, value in item.attrib.items() if name.endswith("label"))]
        style["named"] = style.get("named") or any(map(named_hidden, words))
        style.update({name: item.get(name) for name in ("stroke", "stroke-dasharray", "display") if item.get(name)})
        for body in [rules.get(name, "") for name in (item.get("class") or "").split()] + [item.get("style", "")]:
            style.update((name.strip(), value.strip()) for name, colon, value in (part.partition(":") for part in body.split(";")) if colon)
        if style.get("display") == "none":
            return
        matrix = matrix @ matrix_of(item.get("transform"))
        if kind == "use":
            target = names.get(next((v for k, v in item.attrib.items() if k.endswith("href")), "")[1:])
            moved = matrix @ matrix_of(f"translate({item.get('x', 0)} {item.get('y', 0)})")
            if target is not None:
                visit(target, moved, style)
        if style.get("stroke", "none") != "none":
            dashed = style.get("stroke-dasharray", "none") not in ("none", "0", "")
            for line in shape_lines(kind, item):
                placed = numpy.array([(*point, 1) for point in line]) @ matrix.T
                ink.add([tuple(point) for point in placed[:, :2]], dashed or style["named"])
        for child in item:
            visit(child, matrix, style)

    visit(root, flip, {})
    return ink


# --- DXF

def records(text):
    lines = [line.strip() for line in text.splitlines()]
    record, section = None, None
    for code, value in zip(map(int, lines[::2]), lines[1::2]):
        if code == 0:
            if record:
                yield section, record
            record = [(0, value)]
        elif record:
            if record[0][1] == "SECTION" and code == 2:
                section = value
            record.append((code, value))
    yield section, record


def bulged(corners, closed):
    """Points of a polyline of (x, y, bulge)."""
    points = [corners[0][:2]]
    for (x, y, bulge), (u, v, _) in zip(corners, corners[1:] + (corners[:1] if closed else [])):
        if bulge:
            turn = 4 * math.atan(bulge)
            cot = (1 - bulge * bulge) / (2 * bulge)
            centre = ((x + u) / 2 - cot * (v - y) / 2, (y + v) / 2 + cot * (u - x) / 2)
            points.extend(list(arc_points(centre, (math.dist(centre, (x, y)),) * 2, 0, math.atan2(y - centre[1], x - centre[0]), turn))[1:])
        else:
            points.append((u, v))
    return points


def dxf_points(kind, record):
    """Points of an entity that is complete in itself."""
    value = lambda code, other=0.0: next((float(v) for c, v in record if c == code), other)
    every = lambda code: [float(v) for c, v in record if c == code]
    if kind == "LINE":
        return [(value(10), value(20)), (value(11), value(21))]
    if kind in ("CIRCLE", "ARC"):
        start, end = math.radians(value(50)), math.radians(value(51, 360))
        sweep = (end - start) % (2 * math.pi) or 2 * math.pi
        return list(arc_points((value(10), value(20)), (value(40),) * 2, 0, start, sweep))
    if kind == "ELLIPSE":
        major = math.hypot(value(11), value(21))
        sweep = (value(42, 2 * math.pi) - value(41)) % (2 * math.pi) or 2 * math.pi
        return list(arc_points((value(10), value(20)), (major, major * value(40)), math.atan2(value(21), value(11)), value(41), sweep))
    if kind == "LWPOLYLINE":
        corners = []
        for code, number in record:
            if code == 10:
                corners.append([float(number), 0.0, 0.0])
            elif code in (20, 42) and corners:
                corners[-1][1 if code == 20 else 2] = float(number)
        return bulged([tuple(corner) for corner in corners], int(value(70)) & 1)
    if kind == "SPLINE":
        return list(spline(int(value(71)), every(40), list(zip(every(10), every(20))), every(41)))
    return []


def spline(degree, knots, controls, weights):
    """Points by de Boor's rule."""
    rows = numpy.array([(x * w, y * w, w) for (x, y), w in zip(controls, weights or [1] * len(controls))])
    spans = sorted({k for k in range(degree, len(controls)) if knots[k + 1] > knots[k]})
    for k in spans:
        for t in numpy.linspace(knots[k], knots[k + 1], CURVE + 1)[0 if k == spans[0] else 1:]:
            d = [rows[j] for j in range(k - degree, k + 1)]
            for r in range(1, degree + 1):
                for j in range(degree, r - 1, -1):
                    low = knots[j + k - degree]
                    share = (t - low) / (knots[j + 1 + k - r] - low)
                    d[j] = d[j - 1] * (1 - share) + d[j] * share
            yield d[degree][0] / d[degree][2], d[degree][1] / d[degree][2]


def read_dxf(text):
    ink, types, polyline = Ink(), {}, None
    for section, record in records(text):
        kind, fields = record[0][1], dict(record)
        if kind == "LAYER" and section == "TABLES":
            types[fields.get(2, "").upper()] = fields.get(6, "CONTINUOUS")
        if section != "ENTITIES":
            continue
        layer = fields.get(8, "0")
        line_type = fields.get(6, "BYLAYER").upper()
        line_type = types.get(layer.upper(), "CONTINUOUS") if line_type == "BYLAYER" else line_type
        hidden = line_type.upper() != "CONTINUOUS" or named_hidden(layer)
        if kind == "POLYLINE":
            polyline = ([], int(fields.get(70, 0)) & 1, hidden)
        elif kind == "VERTEX" and polyline:
            polyline[0].append((float(fields[10]), float(fields[20]), float(fields.get(42, 0))))
        elif kind == "SEQEND" and polyline:
            ink.add(bulged(polyline[0], polyline[1]), polyline[2])
            polyline = None
        else:
            ink.add(dxf_points(kind, record), hidden)
    return ink


def read(path):
    """The visible and the hidden segments, rows x0 y0 x1 y1 in mm."""
    ending = str(path).rpartition(".")[2].lower()
    if ending == "pdf":
        return read_svg(subprocess.run(["pdftocairo", "-svg", "-noshrink", path, "-"], check=True, capture_output=True).stdout).segments()
    with open(path, "rb") as file:
        data = file.read()
    return (read_dxf(data.decode("utf-8", "replace")) if ending == "dxf" else read_svg(data)).segments()
