#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The module for Python against the program on the same jobs:  bench/python_time.py EPURA [RUNS]

From a file to SVG, in turns; medians in seconds, and the ratio of the module to the program. "started" includes the start of
Python and the import of numpy. PYTHONPATH must find the module of the same build.
"""
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import epura

SAMPLES = Path(__file__).resolve().parent.parent / "samples"
SCRIPT = "import sys, epura; epura.draw(sys.argv[1], projection='isometric', hidden='dashed').save(sys.argv[2])"


def torus(n):
    """2 n^2 triangles, as OBJ."""
    from math import cos, pi, sin
    text = ["%f %f %f" % ((30 + 10 * cos(b)) * cos(a), (30 + 10 * cos(b)) * sin(a), 10 * sin(b))
            for a in (2 * pi * i / n for i in range(n)) for b in (2 * pi * j / n for j in range(n))]
    faces = []
    for i in range(n):
        for j in range(n):
            a, b, c, d = (i % n * n + j % n + 1 for i, j in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            faces += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    return "v " + "\nv ".join(text) + "\n" + "\n".join(faces) + "\n"


def timed(run):
    begin = time.perf_counter()
    run()
    return time.perf_counter() - begin


def main():
    program, runs = os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 7
    with tempfile.TemporaryDirectory() as folder:
        large = Path(folder, "torus.obj")
        large.write_text(torus(400))
        out = str(Path(folder, "a.svg"))
        print(f"{'model':14} {'program':>8} {'module':>8} {'ratio':>6} {'started':>8} {'ratio':>6}")
        for model in (SAMPLES / "models/bracket.obj", SAMPLES / "models/gear.stl", large):
            ways = (
                lambda: subprocess.run([program, "draw", model, "--projection", "isometric", "--hidden", "dashed", "-o",
                                        out], check=True, capture_output=True),
                lambda: epura.draw(model, projection="isometric", hidden="dashed").save(out),
                lambda: subprocess.run([sys.executable, "-c", SCRIPT, model, out], check=True))
            times = [[], [], []]
            for _ in range(runs):
                for way, taken in zip(ways, times):
                    taken.append(timed(way))
            whole, module, started = (statistics.median(taken) for taken in times)
            print(f"{model.name:14} {whole:8.3f} {module:8.3f} {module / whole:6.2f} {started:8.3f} {started / whole:6.2f}")


main()
