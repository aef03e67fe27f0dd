# SPDX-License-Identifier: Apache-2.0
"""Prints how well programs draw the parts of the bench; bench/drawings/run starts it."""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import ink
import programs
import score
from views import VIEWS, axes_of

HERE = pathlib.Path(__file__).resolve().parent
TIME_LIMIT = 120  # s of processor time for a view; the slowest rival that ends needs a tenth of it
LEAST = 0.5  # mm of an error that is told; less are ends of lines that turn from visible to hidden elsewhere by rounding
GOOD = 0.99  # what falls below it is an error to be shown


def parse(words):
    parser = argparse.ArgumentParser(prog="bench/drawings/run", description="How well programs draw parts, against the faces of the parts themselves.")
    parser.add_argument("--only", default="", help="programs whose name has this text")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for models, truths and drawings; an existing truth in it is used again")
    parser.add_argument("parts", nargs="*", help="parts of parts.py, or STEP files; all of parts.py")
    return parser.parse_args(words)


def truths(folder, names):
    """Makes what is not there yet, and reads it: by part."""
    names = names or part_names()
    missing = [name for name in names if not (folder / f"{pathlib.Path(name).stem}.json").exists()]
    if missing:
        subprocess.run(["python3", HERE / "truth.py", folder, *missing], check=True)
    stems = [pathlib.Path(name).stem for name in names]
    return {stem: json.loads((folder / f"{stem}.json").read_text()) for stem in stems}


def part_names():
    """Without FreeCAD, which parts.py needs to make them."""
    source = (HERE / "parts.py").read_text()
    return [name.strip() for name in source.rpartition("in (")[2].partition(")")[0].split(",")]


def result_of(program, task, truth):
    """A run and its score, or the reason why there is none."""
    try:
        run = programs.draw(program, task, TIME_LIMIT)
        lines = ink.read(run.drawing)
        if len(lines[0]) == 0:
            raise programs.Refusal("no visible line")
        return run, score.score(lines, truth)
    except programs.Refusal as refusal:
        return str(refusal)
    except (ValueError, OSError, SyntaxError) as error:
        return f"unusable drawing: {error}"


def number(value):
    return f"{value:.3f}" + (" *" if value < GOOD else "")


def row_of(program, task, result):
    start = f"| {program.name}, {program.source} | {task.part.name} | {task.view} | "
    if isinstance(result, str):
        return start + result + " |" * 8
    run, s = result
    return start + " | ".join([*map(number, (s.recall, s.precision, s.recall_hidden, s.precision_hidden)), str(s.loose_ends), str(s.strokes),
                               f"{run.seconds:.2f}", f"{run.megabytes:.0f}"]) + " |"


def mean_row(program, results):
    done = [result for result in results if not isinstance(result, str)]
    start = f"| {program.name} {programs.version_of(program)} | {program.source} | {len(done)} | {len(results) - len(done)} | "
    if not done:
        return start + "| " * 8
    mean = lambda values: sum(values) / len(done)
    scores = [s for _, s in done]
    shares = [f"{mean([getattr(s, name) for s in scores]):.4f}" for name in ("recall", "precision", "recall_hidden", "precision_hidden")]
    return start + " | ".join([*shares, f"{mean([s.loose_ends for s in scores]):.1f}", f"{mean([s.strokes for s in scores]):.0f}",
                               f"{mean([run.seconds for run, _ in done]):.2f}", f"{max(run.megabytes for run, _ in done):.0f}"]) + " |"


HEAD = "recall | precision | recall, hidden | precision, hidden | loose ends | strokes | s | MB |"


def errors_of(program, task, result):
    """Sentences about what a view of epura lacks, or has too much."""
    start = f"- {program.name}, {program.source}, {task.part.name}, {task.view}: "
    if isinstance(result, str):
        return [start + result]
    return [start + f"{length:.1f} mm {what}, most around ({place[0]:.1f}, {place[1]:.1f})"
            for what, (length, place) in result[1].errors.items() if length >= LEAST]


def main(words):
    options = parse(words)
    chosen = [program for program in programs.PROGRAMS if options.only.lower() in program.name.lower()]
    with tempfile.TemporaryDirectory() as temporary:
        folder = (options.keep or pathlib.Path(temporary)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        parts = truths(folder, options.parts)
        tasks = [(program, programs.Task(folder / part, view, axes_of(VIEWS[view]), truth["cut"], folder / f"{part}-{view}-{i}"))
                 for i, program in enumerate(chosen) for part, truth in parts.items() for view in VIEWS]
        results = [result_of(program, task, parts[task.part.name]["views"][task.view]) for program, task in tasks]
        report(tasks, results, chosen)


def report(tasks, results, chosen):
    runs = list(zip((program for program, _ in tasks), (task for _, task in tasks), results))
    own = [run for run in runs if run[0].name == "epura"]
    if own:
        print(f"Errors of epura in {len(own)} views:\n\n" + ("\n".join(error for run in own for error in errors_of(*run)) or "none"))
    print(f"\n| program | of | views | refused | {HEAD}\n|---|---|---|---|---|---|---|---|---|---|---|---|")
    for program in chosen:
        print(mean_row(program, [result for other, _, result in runs if other is program]))
    print(f"\n| program | part | view | {HEAD}\n|---|---|---|---|---|---|---|---|---|---|---|")
    for run in runs:
        print(row_of(*run))


main(sys.argv[1:])
