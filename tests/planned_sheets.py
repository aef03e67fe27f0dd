#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sheets that lack a size, or state a wrong one, by plan:  tests/planned_sheets.py EPURA [--count N] [--first N] [--sizes N]

The parts are those of random_sheets.py. `epura lint` must find nothing on a sheet with automatic dimensions; if one of these is put in brackets, and
thus says nothing, a face is free (or nobody can tell); and if its number is another one, its text is untrue.
"""
import argparse
import collections
import json
import os
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import random_sheets


def lint(epura, scene):
    """The axes of a scene, each with its faults and what is undecided."""
    report = scene.with_suffix(".lint.json")
    run = subprocess.run([epura, "lint", str(scene), "--json", str(report)], capture_output=True, text=True, timeout=300, check=False)
    if run.returncode not in (0, 1):
        raise SystemExit(f"{scene}: {run.stderr[-500:]}")
    return json.loads(report.read_text())["axes"]


def dimensions_in(node):
    """What has a text and a value, in the JSON of a sheet."""
    if isinstance(node, list):
        return [one for part in node for one in dimensions_in(part)]
    if not isinstance(node, dict):
        return []
    own = [node] if isinstance(node.get("text"), str) and isinstance(node.get("value"), (int, float)) else []
    return own + [one for part in node.values() for one in dimensions_in(part)]


def with_text(text, said):
    return f"[[dimension]]\nmatch = {json.dumps(text, ensure_ascii=False)}\ntext = {json.dumps(said, ensure_ascii=False)}\n"


def trial(epura, file, lot, most):
    """What lint makes of the sheet, and of those with one fault: pairs of a plan and its verdict."""
    scene = Path(file).with_suffix(".toml")
    plain = f"model = [{{file = {json.dumps(Path(file).name)}}}]\nviews = [\"auto\"]\n[[dimension]]\ntype = \"auto\"\n"
    scene.write_text(plain)
    axes = lint(epura, scene)
    is_whole = axes["completeness"]["faults"] == 0 and axes["completeness"]["undecided"] == 0
    yield "whole", "right" if is_whole and axes["fidelity"]["faults"] == 0 else "incomplete", ""
    if not is_whole:
        return
    subprocess.run([epura, "draw", str(scene), "-o", str(scene.with_suffix(".json"))], capture_output=True, timeout=300, check=True)
    texts = sorted({one["text"] for one in dimensions_in(json.loads(scene.with_suffix(".json").read_text())) if re.match(r"^[⌀R]?\d", one["text"])})
    for text in lot.sample(texts, min(most, len(texts))):
        scene.write_text(plain + with_text(text, "(<>)"))
        axes = lint(epura, scene)["completeness"]
        yield "lacks a size", "found" if axes["faults"] else "cannot tell" if axes["undecided"] else "passed", text
        scene.write_text(plain + with_text(text, re.sub(r"\d+", lambda n: str(int(n[0]) + 1), text, count=1)))
        yield "states another", "found" if lint(epura, scene)["fidelity"]["faults"] else "passed", text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("epura")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--sizes", type=int, default=2, help="of each part that are made faulty")
    given = parser.parse_args()
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        maker = subprocess.Popen([sys.executable, "-c", random_sheets.MADE_BY_FREECAD], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                 env={**os.environ, "PYTHONPATH": "/usr/lib/freecad-python3/lib", "QT_QPA_PLATFORM": "offscreen"})
        for index in range(given.first, given.first + given.count):
            lot = random.Random(f"part epura/{index}")
            steps, _ = lot.choice(random_sheets.FAMILIES)(lot)
            middle = steps[0]["size"][1] / 2 if "size" in steps[0] else steps[0]["axis"][1] / 2
            file = f"{folder}/p{index}.step"
            maker.stdin.write(json.dumps({"file": file, "steps": steps, "middle": middle}) + "\n")
            maker.stdin.flush()
            if not maker.stdout.readline():
                sys.exit(f"FreeCAD made no part {index}: {json.dumps(steps)}")
            for plan, verdict, text in trial(given.epura, file, lot, given.sizes):
                counts[plan, verdict] += 1
                if verdict in ("passed", "incomplete"):
                    print(f"p{index} {plan} {text}: {verdict}", flush=True)
        maker.stdin.close()
    for (plan, verdict), count in sorted(counts.items()):
        print(f"{plan}: {verdict} {count}")
    return 1 if any(verdict in ("passed", "incomplete") for _, verdict in counts) else 0


if __name__ == "__main__":
    sys.exit(main())
