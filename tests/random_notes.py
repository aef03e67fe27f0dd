#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""True and false notes of random parts:  tests/random_notes.py EPURA [--count N] [--first N] [--keep FOLDER] [--list]

FreeCAD (Debian) makes plates and flanges whose sizes are known here. Notes and dimensions say of them what is true, in the signs of ISO and ASME and
in words of five languages; and each once more with one thing changed, so that it is false. `epura lint` must call no true one untrue, and must pass
no false one: it calls it untrue, or tells that it does not understand it. A part and its texts are drawn from the seed and its number alone.
"""
import argparse
import collections
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

MADE_BY_FREECAD = r"""
import json, sys
from FreeCAD import Vector
import Part

def solid(step):
    at, axis = Vector(*step["at"]), Vector(0, 0, 1)
    if step["kind"] == "box":
        return Part.makeBox(*step["size"], at)
    if step["kind"] == "cone":
        return Part.makeCone(step["radius"], step["end"], step["length"], at, axis)
    return Part.makeCylinder(step["radius"], step["length"], at, axis)

for line in sys.stdin:
    part = json.loads(line)
    shape = None
    for step in part["steps"]:
        if step["kind"] in ("fillet", "chamfer"):
            edges = [e for e in shape.Edges if len(e.Vertexes) == 2 and abs(e.Vertexes[0].Z - e.Vertexes[1].Z) > 1e-6
                     and any(all(abs(v.X - x) + abs(v.Y - y) < 1e-6 for v in e.Vertexes) for x, y in step["at"])]
            shape = (shape.makeFillet if step["kind"] == "fillet" else shape.makeChamfer)(step["size"], edges)
            continue
        other = solid(step)
        shape = other if shape is None else shape.fuse(other) if step["add"] else shape.cut(other)
    shape.removeSplitter().exportStep(part["file"])
    print(part["file"], flush=True)
"""

CORE = {4: 3.3, 5: 4.2, 6: 5.0, 8: 6.8, 10: 8.5, 12: 10.2}  # of metric threads: the hole that is drilled
PITCH = {4: 0.7, 5: 0.8, 6: 1, 8: 1.25, 10: 1.5, 12: 1.75}
H7 = {3: 10, 6: 12, 10: 15, 18: 18, 30: 21, 50: 25}  # micrometres, up to a diameter. ISO 286-2.


def number(value):
    return f"{value:.10g}"


class Words:
    """One way to say things, drawn once for a note."""

    def __init__(self, lot):
        self.lot = lot
        self.comma = lot.random() < 0.15

    def one(self, *ways):
        return self.lot.choice(ways)

    def n(self, value):
        text = number(value)
        return text.replace(".", ",") if self.comma else text

    def dia(self, value):
        return self.one("⌀{}", "⌀{}", "⌀{}", "Ø{}", "⌀ {}").format(self.n(value))

    def counted(self, count, text, holes=True):
        if count == 1:
            return text
        front = self.one("{}× ", "{}× ", "{}x ", "{}X ", "{} × ") if not holes else self.one(
            "{}× ", "{}× ", "{}x ", "{}X ", "{} HOLES ", "{} Bohrungen ", "{} trous ", "{} fori ")
        back = self.one(" ({}×)", " {} PLACES", " {} PLCS")
        return text + back.format(count) if self.lot.random() < 0.15 else front.format(count) + text

    def depth(self, value):
        return self.one(" ↧{}", " ↧{}", " ↧ {}", " x {} deep", " X {} DEEP", " DEPTH {}", " Tiefe {}", ", {} tief", " prof. {}", " profondeur {} mm",
                        " prof. {} mm", " profondità {}").format(self.n(value))

    def through(self):
        return self.one("", "", " THRU", " THRU ALL", " through", " durch", " durchgehend", " débouchant", " traversant", " passante", " PASANTE")

    def counterbore(self, d, depth):
        return self.one(" ⌴⌀{}", " ⌴ ⌀{}", " CBORE ⌀{}", " C BORE ⌀{}", " SPOTFACE ⌀{}", ", Senkung ⌀{}", ", Flachsenkung ⌀{}", " lamage ⌀{}",
                        " lamatura ⌀{}").format(self.n(d)) + self.depth(depth)

    def countersink(self, d, angle):
        way = self.one(" ⌵⌀{d}×{a}°", " ⌵⌀{d} × {a}°", " ⌵ ⌀{d} {a}°", " CSK ⌀{d} X {a}°", ", Senkung {a}° ⌀{d}", ", Senkung ⌀{d}×{a}°",
                       " fraisure ⌀{d} à {a}°", " ⌵⌀{d} x {a}°")
        return way.format(d=self.n(d), a=number(angle))

    def thread(self, size, pitch):
        if pitch:
            return self.one("M{}×{}", "M{}x{}").format(number(size), number(pitch)) + self.one("", "-6H", " - 6H")
        return f"M{number(size)}" + self.one("", "", "-6H", " - 6H")

    def circle(self, d):
        return self.one(" ON ⌀{} BC", " ON {} PCD", " auf LK ⌀{}", " auf Lochkreis {}", " ON ⌀{} B.C.", " PCD {}", " sur ⌀{}").format(self.n(d))

    def evenly(self):
        return self.one(" EQ SP", " EQUALLY SPACED", " gleichmäßig verteilt", " équidistants", " EQUISPACED")

    def chamfer(self, leg, angle):
        ways = ["{l}×{a}°", "{l} × {a}°", "{l}x{a}°", "CHAM {l} X {a}°", "chamfer {l}×{a}°", "Fase {l}×{a}°", "chanfrein {l} à {a}°", "{a}°×{l}"]
        if angle == 45:
            ways += ["C{l}", "{l}x{l}"]
        return self.one(*ways).format(l=self.n(leg), a=number(angle))

    def radius(self, value):
        return self.one("R{}", "R{}", "R {}", "Radius {}", "rayon {}", "TYP R{}", "R{} TYP").format(self.n(value))


class Fact:
    """What a text can say, with the place where its leader ends; and how to say it. A change of one value makes it false."""

    def __init__(self, place, say, changes, **values):
        self.place, self.say, self.changes, self.values = place, say, changes, values

    def text(self, lot, false=False):
        values = dict(self.values)
        if false:
            lot.choice(self.changes)(values, lot)
        return self.say(Words(lot), values)


def off(name, low=1, high=3, step=1.0):
    """Changes a length by more than its last digit."""

    def change(values, lot):
        values[name] = round(values[name] + lot.choice((-1, 1)) * step * lot.randrange(low, high + 1), 6)
        if values[name] <= 0:
            values[name] = round(values[name] + 2 * step * high + step, 6)

    return change


def more(values, lot):
    values["count"] += lot.randrange(1, 3)


def put(name, value):
    def change(values, lot):
        values[name] = value

    return change


def through_hole(w, v):
    fit = ""
    if v.get("fit"):
        limit = next(tolerance for largest, tolerance in H7.items() if v["d"] <= largest) + v.get("wrong", 0)
        up = number(v["d"] + limit / 1000)
        fit = w.one(" H7", " H7", f" H7 ({up}/{number(v['d'])})", f" H7 (+{limit / 1000:.3f}/0)")
        if v.get("wrong"):
            fit = f" H7 ({up}/{number(v['d'])})"
    end = w.depth(v["depth"]) if v.get("depth") else w.through()
    return w.counted(v["count"], w.dia(v["d"]) + fit + end)


def along_hole(w, v):
    return w.dia(v["d"]) + w.one("×{}", " x {}", " × {}").format(w.n(v["depth"]))


def blind_hole(w, v):
    return w.counted(v["count"], w.dia(v["d"]) + (w.one(" THRU", " durch", " débouchant") if v.get("through") else w.depth(v["depth"])))


def counterbored(w, v):
    recess = w.countersink(v["big"], 90) if v.get("sunk") else w.counterbore(v["big"], v["depth"])
    return w.counted(v["count"], w.dia(v["d"]) + w.through() + recess)


def countersunk(w, v):
    recess = w.counterbore(v["big"], 2) if v.get("bored") else w.countersink(v["big"], v["angle"])
    return w.counted(v["count"], w.dia(v["d"]) + w.through() + recess)


def tapped(w, v):
    drill = ""
    if v["drilled"]:
        drill = w.one(" / ", "/").strip(" ") if w.lot.random() < 0.5 else " / "
        drill += f"⌀{w.n(v['drill'])}" + w.one(" ↧{}", "↧{}").format(w.n(v["drilled"]))
    return w.counted(v["count"], w.thread(v["size"], v["pitch"]) + w.one(" ↧{}", " ↧{}", " x {} deep", " Tiefe {}").format(w.n(v["depth"])) + drill)


def on_circle(w, v):
    return w.counted(v["count"], w.dia(v["d"])) + (w.evenly() if v["even"] else "") + w.circle(v["circle"])


def spaced(w, v):
    return w.counted(v["count"], w.dia(v["d"])) + f" ({number(v['angle'])}°)"


def disc(w, v):
    return w.dia(v["d"]) + w.one("×{}", " x {}", " × {}", " x {} long", " t={}", " x {} thick", " x {} lang", ", {} dick").format(w.n(v["depth"]))


def fillets(w, v):
    return w.counted(v["count"], w.radius(v["r"]), holes=False)


def chamfered(w, v):
    return w.chamfer(v["leg"], v["angle"])


def all_fillets(w, v):
    r = w.n(v["r"])
    return w.one("ALL FILLETS R{}", "all radii R{} unless otherwise stated", "alle Radien R{}", "nicht bemaßte Rundungen R{}", "tous les congés R{}",
                 "UNLESS OTHERWISE SPECIFIED ALL FILLETS ARE R{}", "sofern nicht anders angegeben alle Rundungen R{}").format(r)


def thickness(w, v):
    return w.one("PLATE {} THICK", "Thickness {}", "THICKNESS: {} mm", "Dicke {} mm", "Blechdicke {}", "Platte {} dick", "Épaisseur {} mm", "tôle ép. {}",
                 "Spessore {}", "Espesor {} mm", "t = {}").format(w.n(v["thick"]))


def ribs(w, v):
    return w.one("all ribs {} thick", "ALL RIBS {} THK", "alle Rippen {} dick", "Rippen {} mm dick", "toutes les nervures ép. {}",
                 "RIBS {} THICK UNLESS OTHERWISE SPECIFIED").format(w.n(v["thick"]))


def overall(w, v):
    return w.one("OVERALL LENGTH {}", "Length {} mm", "Länge {}", "Gesamtlänge {} mm", "longueur {}", "longueur hors tout {} mm", "lunghezza {}",
                 "L = {}", "{} long").format(w.n(v["length"]))


def all_threads(w, v):
    text = f"M{number(v['size'])}"
    return w.one("ALL THREADS {}", "all threads {}-6H", "alle Gewinde {}", "tous les filetages {}", "THREADS {} UNLESS OTHERWISE SPECIFIED",
                 "Gewinde {}, soweit nicht anders angegeben").format(text)


def some_threads(w, v):
    text = f"M{number(v['size'])}" + w.one(" ↧{}", " x {} deep", " Tiefe {}").format(w.n(v["depth"]))
    return f"{v['count']} " + w.one("Gewinde", "THREADS", "filetages") + " " + text if w.lot.random() < 0.5 else f"{v['count']}× " + text


def blind_holes(w, v):
    return w.one("ALL BLIND HOLES {} DEEP", "alle Sacklöcher {} tief", "Sacklöcher {} tief", "tous les trous borgnes prof. {}").format(w.n(v["depth"]))


def all_holes(w, v):
    return w.one("ALL HOLES THRU", "all holes through", "alle Bohrungen durchgehend", "tous trous débouchants")


def length_text(w, v):
    n = w.n(v["length"])
    inches = f"{v['length'] / 25.4:.3f}"
    ways = ["{n}", "{n} ±0.1", "({n})", "{n} REF", "{n} H7", "{n} mm", "{n} TYP", "ca. {n}", "{n} max.", "MIN {n}", "[{n}]", "{n} +0.2 -0.1", "{n}.0",
            "{n} THEO", "{i} in", "{i}\"", "{n} ({i} in)", "{n} [{i}]", "{c} cm", "{n} long"]
    if w.comma:
        ways = ["{n}", "{n} ±0,1", "({n})"]
    if v.get("sign"):
        ways = [v["sign"]]
    return w.one(*ways).format(n=n, i=inches, c=number(v["length"] / 10))


def cylinder(x, y, z, d, length, add=False):
    return {"kind": "cylinder", "add": add, "at": (x, y, z), "radius": d / 2, "length": length}


def plate(lot):
    length, width, height = 30 * lot.randrange(4, 6) + lot.randrange(0, 10), 30 * 3 + lot.randrange(5, 15), lot.randrange(16, 26)
    steps, facts = [{"kind": "box", "add": True, "at": (0, 0, 0), "size": (length, width, height)}], []
    cells = [(20 + 28 * i, 20 + 27 * j) for i in range((length - 14) // 28) for j in range(3)]
    lot.shuffle(cells)
    diameters = [d / 2 for d in range(9, 23)]  # of holes, each for one kind
    lot.shuffle(diameters)
    kinds = ["through", "blind", "point", "counterbore", "countersink", "tapped"]
    lot.shuffle(kinds)
    any_blind = False
    threads, blind_depths = [], set()
    for kind in kinds:
        count = lot.choice((1, 2, 2, 3))
        if len(cells) < count:
            break
        places, cells = cells[:count], cells[count:]
        d, big, depth = diameters.pop(), 14 + 2 * lot.randrange(0, 4), lot.randrange(5, height - 6)
        size = lot.choice((4, 5, 6, 8, 10, 12))
        angle = lot.choice((90, 82, 120))
        if kind == "tapped":
            d, depth = CORE[size], height - 4
        cone = (big - d) / 2 / math.tan(math.radians(angle / 2))
        if kind == "countersink" and cone > height - 3:
            kind = "through"
        for x, y in places:
            if kind in ("through", "counterbore", "countersink"):
                steps.append(cylinder(x, y, -1, d, height + 2))
            else:
                steps.append(cylinder(x, y, height - depth, d, depth + 1))
            if kind == "counterbore":
                steps.append(cylinder(x, y, height - depth, big, depth + 1))
            if kind == "countersink":
                steps.append({"kind": "cone", "add": False, "at": (x, y, height - cone), "radius": d / 2, "end": big / 2, "length": cone})
            if kind == "point":
                rise = d / 2 / math.tan(math.radians(59))
                steps.append({"kind": "cone", "add": False, "at": (x, y, height - depth - rise), "radius": 0, "end": d / 2, "length": rise})
        x, y = places[0]
        rim, mouth = (x + d / 2, y, height), (x + big / 2, y, height)
        any_blind = any_blind or kind in ("blind", "point", "tapped")
        if kind in ("blind", "point", "tapped"):
            blind_depths.add(depth)
        where = rim if kind == "through" else lot.choice((rim, (x, y, height)))  # or in the middle, where the view shows a floor
        if kind in ("through", "blind", "point"):
            say, changes = (through_hole, []) if kind == "through" else (blind_hole, [off("depth"), put("through", True)])
            facts.append(Fact(where, say, [off("d"), more, *changes], d=d, count=count, depth=0 if kind == "through" else depth))
            facts.append(Fact(None, say, [off("d", 30, 40), more, *changes], d=d, count=count,
                              depth=0 if kind == "through" else depth))
        if kind == "countersink":
            facts.append(Fact(f"hole at {x} {y}", through_hole, [off("d", 2, 4, step=0.5), more], d=d, count=count))
        if kind == "through":
            for fit in (False, True):
                wrong = [put("wrong", 6)] if fit and d * 2 % 2 == 0 else []
                facts.append(Fact(rim, through_hole, [off("d", 2, 6, step=0.5), more, put("depth", height - 5)] + wrong, d=d, count=count, fit=fit))
            facts.append(Fact(rim, along_hole, [off("depth"), off("d")], d=d, depth=height))
        if kind in ("blind", "point"):
            facts.append(Fact(rim, blind_hole, [off("d"), more, off("depth"), put("through", True)], d=d, count=count, depth=depth))
            facts.append(Fact(rim, along_hole, [off("depth"), off("d")], d=d, depth=depth))
        if kind == "counterbore":
            facts.append(Fact(mouth, counterbored, [off("d"), more, off("depth"), off("big"), put("sunk", True)], d=d, count=count, depth=depth, big=big))
        if kind == "countersink":
            other = put("angle", {90: 100, 82: 90, 120: 90}[angle])
            facts.append(Fact(mouth, countersunk, [off("d"), more, other, off("big"), put("bored", True)], d=d, count=count, angle=angle, big=big))
        if kind == "tapped":
            other = {4: 6, 5: 8, 6: 8, 8: 12, 10: 6, 12: 8}[size]
            if lot.random() < 0.7:  # it is known how deep it is
                threads = [{"thread": f"M{size}", "depth": depth - 3, "at": (x, y, height)} for x, y in places]
                facts.append(Fact(None, all_threads, [put("size", other)], size=size))
                facts.append(Fact(None, some_threads, [off("depth"), put("size", other), more], count=count, size=size, depth=depth - 3))
            for drilled in (0, depth):
                changes = [more, put("size", other), off("depth") if threads else put("depth", depth + 3)]
                changes += [off("drill", 2, 6, step=0.5), off("drilled")] if drilled else []
                facts.append(Fact(rim, tapped, changes, count=count, size=size, pitch=lot.choice((0, PITCH[size])), depth=depth - 3, drilled=drilled, drill=d))
    r = lot.choice([value for value in (2, 3, 5, 6) if value not in diameters] + [d / 2 for d in diameters[:1]])
    corners = [(0, 0), (length, 0), (0, width), (length, width)][:lot.choice((2, 3, 4))]
    steps.append({"kind": lot.choice(("fillet", "fillet", "chamfer")), "at": corners, "size": r})
    x, y = corners[0]
    if steps[-1]["kind"] == "fillet":
        side = r * (1 - math.sqrt(0.5))
        facts.append(Fact((side, side, height), fillets, [off("r"), more], r=r, count=len(corners)))
        facts.append(Fact(None, all_fillets, [off("r")], r=r))
    else:
        facts.append(Fact((r / 2, r / 2, height), chamfered, [off("leg"), put("angle", 30)], leg=r, angle=45))
    facts.append(Fact(None, thickness, [off("thick"), put("thick", width), put("thick", length)], thick=height))
    facts.append(Fact(None, overall, [off("length")], length=length))
    facts.append(Fact(None, lambda w, v: ribs(w, v) if v["false"] else "", [put("false", True)], false=False, thick=height + 7))
    if len(blind_depths) == 1:
        facts.append(Fact(None, blind_holes, [off("depth")], depth=blind_depths.pop()))
    if any_blind:
        facts.append(Fact(None, lambda w, v: all_holes(w, v) if v["false"] else "", [put("false", True)], false=False))
    for ends, value in ((((0, width, height), (length, width, height)), length), (((0, 0, 0), (length, 0, 0)), length)):
        changes = [off("length"), put("sign", "⌀{n}"), put("sign", "R{n}"), put("sign", "{n}°"), put("sign", "{n} THRU"), put("sign", "M{n}")]
        facts.append(Fact(ends, length_text, changes, length=value))
    return steps, facts, threads


def ribbed(lot):
    length, width, height, thick, count = 100, 60, lot.randrange(8, 13), lot.choice((3, 4, 5, 6)), lot.choice((2, 3))
    steps = [{"kind": "box", "add": True, "at": (0, 0, 0), "size": (length, width, height)}]
    steps += [{"kind": "box", "add": True, "at": (10 + 30 * i, 0, height), "size": (thick, width, 30)} for i in range(count)]
    facts = [Fact(None, ribs, [off("thick", 20, 30, step=0.1)], thick=thick), Fact(None, thickness, [off("thick", 13, 17, step=0.1)], thick=height),
             Fact(None, overall, [off("length", 3, 7)], length=length)]
    return steps, facts, []


def flange(lot):
    d, height, count = 10 * lot.randrange(9, 13), lot.randrange(8, 16), lot.choice((3, 4, 5, 6, 8))
    circle, hole, bore, leg = d - 24, lot.choice((7, 9, 11)), lot.choice((20, 25, 30)), lot.choice((1, 1.5, 2))
    start = math.radians(lot.choice((0, 90, 180 / count, 10)))
    steps = [cylinder(0, 0, 0, d, height, add=True), {"kind": "cone", "add": True, "at": (0, 0, height), "radius": d / 2, "end": d / 2 - leg, "length": leg}]
    steps.append(cylinder(0, 0, -1, bore, height + leg + 2))
    top = height + leg
    places = [(circle / 2 * math.cos(start + math.tau * i / count), circle / 2 * math.sin(start + math.tau * i / count)) for i in range(count)]
    steps += [cylinder(x, y, -1, hole, top + 2) for x, y in places]
    x, y = places[0]
    rim = (x + hole / 2, y, top)
    facts = [Fact(rim, through_hole, [off("d"), more, put("depth", height - 3)], d=hole, count=count)]
    for even in (False, True):
        facts.append(Fact(rim, on_circle, [off("d"), more, off("circle", 2, 6)], d=hole, count=count, circle=circle, even=even))
    facts.append(Fact(rim, spaced, [off("angle", 2, 6)], d=hole, count=count, angle=360 / count))
    facts.append(Fact((0, d / 2, height), disc, [off("depth"), off("d", 2, 4)], d=d, depth=height))
    facts.append(Fact((0, d / 2 - leg / 2, height + leg / 2), chamfered, [off("leg"), put("angle", 30)], leg=leg, angle=45))
    facts.append(Fact((bore / 2, 0, top), through_hole, [off("d"), put("depth", height - 4)], d=bore, count=1, fit=lot.random() < 0.5))
    facts.append(Fact(None, on_circle, [off("d", 30, 40), more, off("circle", 2, 6)], d=hole, count=count, circle=circle, even=lot.random() < 0.5))
    return steps, facts, []


FAMILIES = (plate, flange, plate, flange, plate, ribbed)


def texts_of(number, seed):
    """The steps of a part, its threads, and texts with whether they are true and where they are, each text once."""
    lot = random.Random(f"{seed}/{number}")
    steps, facts, threads = FAMILIES[number % len(FAMILIES)](lot)
    texts = {}
    for fact in facts:
        for false in (False, True, False, True, False, True):
            text = fact.text(lot, false)
            if text and text not in texts:
                texts[text] = (not false, fact.place)
    return steps, threads, texts


def leader_end(place, names):
    """A point, or the name of the hole that is nearest."""
    if not isinstance(place, str):
        return f"{{point = [{', '.join(f'{value:.6g}' for value in place)}]}}"
    x, y = map(float, place.split()[2:])
    return json.dumps(min(names, key=lambda name: math.dist(names[name], (x, y))))


def scene_of(file, part, alone, names):
    """With the notes of holes and radii, or with those without a leader, which do not mean what others give."""
    _, threads, texts = part
    lines = ["[sheet]", 'size = "A0"', "[[model]]", f'file = "{file}"', "[[view]]", 'projection = "front"', "[[view]]", 'projection = "top"']
    for one in threads:
        at = ", ".join(map(number, one["at"]))
        lines += ["[[thread]]", f'thread = "{one["thread"]}"', f"depth = {one['depth']}", f"at = {{point = [{at}]}}", "callout = false"]
    for text, (_, place) in texts.items():
        quoted = json.dumps(text, ensure_ascii=False)
        if (place is None) != alone:
            continue
        if place is None:
            lines += ["[[note]]", f"text = {quoted}"]
        elif isinstance(place[0], tuple):
            ends = [f"{end} = {{point = [{', '.join(map(number, at))}]}}" for end, at in zip(("from", "to"), place)]
            lines += ["[[dimension]]", 'view = "top"', 'type = "linear"', 'direction = "horizontal"', *ends, f"text = {quoted}"]
        else:
            lines += ["[[note]]", f"text = {quoted}", f"to = {leader_end(place, names)}", 'view = "top"']
    return "\n".join(lines) + "\n"


def places_of_holes(epura, part, texts):
    """The places in the plane of the mouths of holes, by the names that `epura info` gives them, if a text needs them."""
    if not any(isinstance(place, str) for _, place in texts.values()):
        return {}
    run = subprocess.run([epura, "info", str(part), "--json", "-"], capture_output=True, text=True, timeout=300, check=True)
    return {f"hole {one['number']}": tuple(one["from"][:2]) for one in json.loads(run.stdout)["models"][0]["holes"]}


def judged(epura, scene):
    """The kinds of findings by text."""
    report = scene.with_suffix(".json")
    command = [epura, "lint", str(scene), "--json", str(report)]
    run = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    if run.returncode not in (0, 1):
        raise SystemExit(f"{scene}: {run.stderr[-500:]}")
    found = collections.defaultdict(list)
    for finding in json.loads(report.read_text())["findings"]:
        if finding["axis"] == "fidelity":
            found[finding["what"].split("' in view '")[0].split("': ")[0].lstrip("'")].append((finding["kind"], finding["what"]))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("epura")
    parser.add_argument("--count", type=int, default=40, help="parts")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=Path, help="folder for parts and scenes")
    parser.add_argument("--list", action="store_true", help="tell what is not judged, too")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        parts = {n: texts_of(n, options.seed) for n in range(options.first, options.first + options.count)}
        wanted = [json.dumps({"file": str(folder / f"{n}.step"), "steps": steps}) for n, (steps, _, _) in parts.items()]
        make = subprocess.run([sys.executable, "-c", MADE_BY_FREECAD], input="\n".join(wanted) + "\n", text=True, capture_output=True, timeout=1800,
                              env={**os.environ, "PYTHONPATH": "/usr/lib/freecad-python3/lib"}, check=False)
        if make.returncode != 0:
            raise SystemExit(make.stderr[-2000:])
        counts = collections.Counter()
        for n, part in parts.items():
            found, texts = {}, part[2]
            names = places_of_holes(options.epura, folder / f"{n}.step", texts)
            for alone in (False, True):
                scene = folder / f"{n}{'-general' if alone else ''}.toml"
                scene.write_text(scene_of(f"{n}.step", part, alone, names))
                found |= judged(options.epura, scene)
            for text, (is_true, _) in texts.items():
                kinds = [kind for kind, _ in found.get(text, [])]
                verdict = "untrue" if "untrue" in kinds or "contradictory" in kinds else "not judged" if "not judged" in kinds else "passed"
                counts[is_true, verdict] += 1
                if (is_true and verdict == "untrue") or (not is_true and verdict == "passed") or (options.list and verdict == "not judged"):
                    told = "; ".join(what.split("': ", 1)[-1] for _, what in found.get(text, []))
                    print(f"{n}: {'true' if is_true else 'false'} {text!r}: {verdict} {told}")
    for is_true in (True, False):
        print("true" if is_true else "false", sum(count for (one, _), count in counts.items() if one == is_true),
              {verdict: counts[is_true, verdict] for verdict in ("passed", "untrue", "not judged")})
    return 1 if counts[True, "untrue"] or counts[False, "passed"] else 0


if __name__ == "__main__":
    sys.exit(main())
