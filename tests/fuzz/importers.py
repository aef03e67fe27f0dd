#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Damaged files through the whole program:  tests/fuzz/importers.py EPURA [--count N] [--seed N] [--keep FOLDER] [--workers N]

STEP, IGES, BREP, 3MF, glTF and GLB: parts of bench/drawings, written by FreeCAD (Debian), and bodies written here, with numbers,
references, lines and bytes changed. libFuzzer cannot follow Open CASCADE, and a crash of its would end it; here an importer may
crash, since it has a process of its own, but epura may not: a run draws, or says which file it refuses and why, in bounded time
and memory, and leaves the drawing that was there. Damage is drawn from the seed and the number of a file alone.
"""
import argparse
import base64
import collections
import concurrent.futures
import io
import json
import os
import random
import re
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[2]
LONGEST = 150  # s: what an importer may take without progress (120 s), and the rest of a run
LARGEST = 2600  # MB: what an importer may take (2 GB), and the program beside it
BEFORE = "<svg>what was there</svg>"
PARTS = ("stud", "flange", "elbow", "link", "clamp")

MADE_BY_FREECAD = """
import sys
sys.path.insert(0, sys.argv[1])
import FreeCAD, Part, parts
for name in sys.argv[3:]:
    shape = getattr(parts, name)()
    for ending, write in (("step", shape.exportStep), ("iges", shape.exportIges), ("brep", shape.exportBrep)):
        write(f"{sys.argv[2]}/{name}.{ending}")
"""

CORNERS = [(x, y, z) for z in (0, 10) for y in (0, 20) for x in (0, 30)]
TRIANGLES = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
             (1, 3, 7), (1, 7, 5)]


def gltf(uri=None):
    """Two nodes with one box; binary data within the file, or where `uri` says."""
    points = b"".join(struct.pack("<3f", *corner) for corner in CORNERS)
    indices = b"".join(struct.pack("<3H", *triangle) for triangle in TRIANGLES)
    buffer = {"byteLength": len(points + indices)}
    if uri:
        buffer["uri"] = uri
    return points + indices, {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0, "name": "base"}, {"mesh": 0, "translation": [0, 0, 10], "rotation": [0, 0, 0.6, 0.8]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0], "max": [30, 20, 10]},
                      {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": len(points)},
                        {"buffer": 0, "byteOffset": len(points), "byteLength": len(indices)}],
        "buffers": [buffer]}


def glb(binary, scene):
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    binary += bytes(-len(binary) % 4)
    chunks = struct.pack("<2I", len(text), 0x4E4F534A) + text + struct.pack("<2I", len(binary), 0x004E4942) + binary
    return b"glTF" + struct.pack("<2I", 2, 12 + len(chunks)) + chunks


MODEL = "3D/3dmodel.model"


def package(model):
    """A 3MF with this model."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as zipped:
        zipped.writestr("[Content_Types].xml",
                        '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
                        '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
                        '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>')
        zipped.writestr("_rels/.rels",
                        '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r" '
                        f'Target="/{MODEL}" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
        zipped.writestr(MODEL, model)
    return file.getvalue()


def model_of_3mf():
    corners = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in CORNERS)
    triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in TRIANGLES)
    return ('<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
            f'<object id="1" type="model"><mesh><vertices>{corners}</vertices><triangles>{triangles}</triangles></mesh></object>'
            '<object id="2" type="model"><components><component objectid="1" transform="1 0 0 0 1 0 0 0 1 5 0 10"/></components>'
            '</object></resources><build><item objectid="1"/><item objectid="2"/></build></model>').encode()


def sources(folder):
    """Whole files by extension; of packed ones what is in them, since damage to the package itself is seldom read further."""
    subprocess.run([sys.executable, "-c", MADE_BY_FREECAD, str(ROOT / "bench/drawings"), folder, *PARTS], check=True,
                   env={**os.environ, "PYTHONPATH": "/usr/lib/freecad-python3/lib", "QT_QPA_PLATFORM": "offscreen"})
    found = {ending: [(Path(folder) / f"{name}.{ending}").read_bytes() for name in PARTS] for ending in ("step", "iges", "brep")}
    found["step"].append((ROOT / "samples/step/clamp.step").read_bytes())
    binary, _ = gltf()
    within = gltf("data:application/octet-stream;base64," + base64.b64encode(binary).decode())[1]
    return {**found, "3mf": [model_of_3mf()], "gltf": [json.dumps(within).encode()], "glb": [binary]}


NUMBERS = [b"0", b"-1", b"1E300", b"-1E-300", b"NAN", b"1E999", b"2147483648", b"-2147483649", b"18446744073709551616", b"0.1",
           b"1000000", b""]
NUMBER = re.compile(rb"-?\d+\.?\d*(?:[eE][-+]?\d+)?")


def other_number(data, lot):
    found = list(NUMBER.finditer(data))
    if not found:
        return data
    at = lot.choice(found)
    value = lot.choice(NUMBERS + [lot.choice(found).group(), at.group() + b"0", b"-" + at.group()])
    return data[:at.start()] + value + data[at.end():]


def other_line(data, lot):
    lines = data.splitlines(keepends=True)
    i, j = lot.randrange(len(lines)), lot.randrange(len(lines))
    action = lot.randrange(4)
    if action == 0:
        del lines[i]
    elif action == 1:
        lines.insert(j, lines[i])
    elif action == 2:
        lines[i], lines[j] = lines[j], lines[i]
    else:
        lines[i:i] = [lines[j]] * lot.choice((2, 50, 2000))
    return b"".join(lines)


def other_piece(data, lot):
    i, j, length = lot.randrange(len(data)), lot.randrange(len(data)), lot.choice((1, 4, 16, 64, 512))
    action = lot.randrange(4)
    if action == 0:
        return data[:i]
    if action == 1:
        return data[:i] + data[i + length:]
    if action == 2:
        return data[:i] + data[j:j + length] + data[i + length:]
    return data[:i] + bytes(lot.randrange(256) for _ in range(min(length, 16))) + data[i + min(length, 16):]


def other_word(data, lot):
    """A word in the place of another one: a type, a keyword, a reference."""
    found = list(re.finditer(rb"[#A-Za-z_][\w#]*", data))
    if not found:
        return data
    at = lot.choice(found)
    return data[:at.start()] + lot.choice(found).group() + data[at.end():]


def damaged(whole, lot):
    for _ in range(lot.choice((1, 1, 1, 2, 4, 12))):
        kind = lot.choice((other_number, other_number, other_line, other_piece, other_word))
        whole = kind(whole, lot) or whole
    return whole


def file_of(ending, whole, lot):
    """The damaged file; a package is damaged inside, and once in eight times outside."""
    if ending not in ("3mf", "glb"):
        return damaged(whole, lot)
    if lot.randrange(8) == 0:
        return other_piece(package(whole) if ending == "3mf" else glb(whole, gltf()[1]), lot)
    if ending == "3mf":
        return package(damaged(whole, lot))
    text = damaged(json.dumps(gltf()[1]).encode(), lot)
    try:
        scene = json.loads(text)
    except ValueError:
        scene = gltf()[1]
    return glb(other_piece(whole, lot) if lot.randrange(2) else whole, scene)


def run(epura, model, output):
    """Exit code or signal, messages, megabytes; None for a run that does not end."""
    def bound():
        os.setsid()
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    process = subprocess.Popen([epura, "draw", model, "-o", output, "--views", "front,isometric", "--threads", "1"],
                               stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, preexec_fn=bound)
    timer = concurrent.futures.ThreadPoolExecutor(1)
    reader = timer.submit(process.stderr.read)
    try:
        messages = reader.result(LONGEST)
    except concurrent.futures.TimeoutError:
        os.killpg(process.pid, signal.SIGKILL)
        messages = reader.result()
        process.wait()
        return None, messages.decode(errors="replace"), 0
    _, status, usage = os.wait4(process.pid, 0)
    return os.waitstatus_to_exitcode(status), messages.decode(errors="replace"), usage.ru_maxrss / 1024


def faults(code, messages, megabytes, model, output):
    """What a user must not meet."""
    if code is None:
        return [f"did not end within {LONGEST} s"]
    found = []
    if code < 0 or code not in (0, 1, 2, 3, 4, 5):
        found.append(f"ended with {code}")
    if megabytes > LARGEST:
        found.append(f"took {megabytes:.0f} MB")
    text = Path(output).read_text(errors="replace")
    if code in (0, 1, 5):
        try:
            ElementTree.fromstring(text)
        except ElementTree.ParseError as error:
            found.append(f"wrote a drawing that is no XML: {error}")
        if code == 0 and "<path" not in text:
            found.append("drew nothing, and ended with 0")
    elif text != BEFORE:
        found.append("refused, and changed the drawing that was there")
    if code and Path(model).name not in messages:
        found.append("did not name the file")
    if re.search(r"\*\*\*\*|Standard_|TKernel|terminate called|Traceback", messages):
        found.append("passed on words of a library")
    return found


def trial(epura, seed, number, wholes, folder, keep):
    lot = random.Random(f"{seed}/{number}")
    ending = sorted(wholes)[number % len(wholes)]
    model, output = folder / f"m{number}.{ending}", folder / f"m{number}.svg"
    model.write_bytes(file_of(ending, lot.choice(wholes[ending]), lot))
    output.write_text(BEFORE)
    code, messages, megabytes = run(epura, str(model), str(output))
    wrong = faults(code, messages, megabytes, model, output)
    if wrong and keep:
        (keep / model.name).write_bytes(model.read_bytes())
    model.unlink()
    output.unlink()
    crashed = bool(re.search(r"crash|signal|memory|without progress|time", messages)) and code not in (0, 1)
    return ending, code, crashed, [f"m{number}.{ending}: {what}: {messages.strip()[:300]}" for what in wrong]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("epura")
    parser.add_argument("--count", type=int, default=20000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", default="epura")
    parser.add_argument("--keep", type=Path, help="a folder for files that show a fault")
    parser.add_argument("--workers", type=int, default=2)
    given = parser.parse_args()
    if given.keep:
        given.keep.mkdir(parents=True, exist_ok=True)
    drawn, refused, stopped = (collections.Counter() for _ in range(3))
    found = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(given.workers) as pool:
        wholes = sources(folder)
        numbers = range(given.first, given.first + given.count)
        for ending, code, crashed, wrong in pool.map(
                lambda number: trial(given.epura, given.seed, number, wholes, Path(folder), given.keep), numbers):
            (drawn if code in (0, 1, 5) else stopped if crashed else refused)[ending] += 1
            found += bool(wrong)
            for line in wrong:
                print(line, flush=True)
    for ending in sorted(wholes):
        print(f"{ending:5} {drawn[ending]:6} drawn {refused[ending]:6} refused {stopped[ending]:6} importers ended by a crash or a limit")
    print(f"{found} of {given.count} files show a fault")
    sys.exit(found > 0)


if __name__ == "__main__":
    main()
