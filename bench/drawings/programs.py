# SPDX-License-Identifier: Apache-2.0
"""The programs of the bench. Each is one row of PROGRAMS; to add one, say how it draws a view 1:1 into SVG, PDF or DXF.

They are run as their own users would: from the format that the program is best at, with the defaults of its own lines, hidden lines where
it has them.
"""

import dataclasses
import os
import pathlib
import re
import resource
import signal
import subprocess
import typing

HERE = pathlib.Path(__file__).resolve().parent
WAITING = 60  # s without any processor time, after which a program is taken to wait for ever


@dataclasses.dataclass
class Task:
    """Draw this part from this direction into `output`, which has no extension yet."""

    part: pathlib.Path  # without the extension: .step and .stl are beside each other
    view: str
    axes: typing.Sequence  # rows: right, up, towards the viewer
    cut: float  # where the plane of a section meets the axis y
    output: pathlib.Path

    def is_section(self):
        return self.view == "section"

    def file(self, ending):
        return f"{self.part}.{ending}"

    def half(self, ending):
        """For programs that cut nothing themselves: what a section is to show."""
        return f"{self.part}-half.{ending}" if self.is_section() else self.file(ending)

    def drawing(self, ending):
        return self.output.with_suffix("." + ending)

    def viewer(self):
        return [repr(float(value)) for value in self.axes[2]]


@dataclasses.dataclass
class Run:
    drawing: pathlib.Path
    seconds: float  # of processor time
    megabytes: float


class Refusal(Exception):
    """A program did not draw: why."""


def worked(session):
    """The processor time of all processes of a session, in ticks."""
    ticks = 0
    for status in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = status.read_text(errors="replace").rpartition(")")[2].split()  # state, parent, group, session ...
        except OSError:  # it has ended
            continue
        if int(fields[3]) == session:
            ticks += sum(map(int, fields[11:15]))
    return ticks


def timed(command, limit):
    """Runs a command to its end, or a refusal. It ends at the limit, whichever of its threads took the time, and so does each process that it starts."""
    limits = lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))
    before = -1
    with open(os.devnull) as nothing, subprocess.Popen(
            command, stdin=nothing, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True, preexec_fn=limits) as process:
        while True:
            try:
                _, says = process.communicate(timeout=WAITING)
                break
            except subprocess.TimeoutExpired:
                before, last = worked(process.pid), before
                if before == last:
                    os.killpg(process.pid, signal.SIGKILL)
                    process.communicate()
                    raise Refusal(f"waits for something: no processor time in {WAITING} s") from None
    if process.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        raise Refusal(f"no drawing in {limit} s of processor time")
    if process.returncode:
        lines = says.decode("utf-8", "replace").strip().splitlines() or ["no reason given"]
        raise Refusal(f"exit code {process.returncode}: {lines[-1][:100]}")


def measure(command, limit):
    """The same in a process of its own, so that only this command counts."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reader)
        try:
            timed(command, limit)
            usage = resource.getrusage(resource.RUSAGE_CHILDREN)
            word = f"{usage.ru_utime + usage.ru_stime} {usage.ru_maxrss / 1024}"
        except (Refusal, OSError) as error:
            word = f"refused {error}"
        os.write(writer, word.encode())
        os._exit(0)
    os.close(writer)
    with os.fdopen(reader) as pipe:
        word = pipe.read()
    os.waitpid(child, 0)
    if word.startswith("refused "):
        raise Refusal(word.removeprefix("refused "))
    return [float(number) for number in word.split()]


def epura(source):
    def run(task, limit):
        output = task.drawing("svg")
        view = ["--projection", task.view, "--hidden", "dashed"]
        if task.is_section():
            view = ["--projection", "front", "--section", f"0,{task.cut!r},0:0,-1,0", "--hatch", "none"]
        return output, measure([os.environ["EPURA"], "draw", task.file(source), *view, "--scale", "1:1", "--sheet", "none", "-o", output], limit)
    return run


def open_cascade(kind):
    def run(task, limit):
        output = task.drawing("svg")
        return output, measure([os.environ["OCC_LINES"], kind, task.half("step"), *task.viewer(), output], limit)
    return run


def techdraw(task, limit):
    output = task.drawing("svg")
    return output, measure(["python3", HERE / "techdraw.py", task.file("step"), *task.viewer(), output, *([repr(task.cut)] if task.is_section() else [])], limit)


def blender(task, limit):
    rows, output = task.drawing("txt"), task.drawing("svg")
    used = measure(["blender", "-b", "--factory-startup", "--python-exit-code", "2", "-P", HERE.parent / "blender_lines.py", "--",
                    "front" if task.is_section() else task.view, "intersections", task.half("stl"), rows], limit)
    lines = [line.split() for line in rows.read_text().splitlines()]
    output.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="1000mm" height="1000mm" viewBox="0 0 1000 1000" stroke="#000">\n' + "".join(
        f'<path d="M{x0} {-float(y0)} {x1} {-float(y1)}"/>\n' for x0, y0, x1, y1 in lines) + "</svg>\n")
    return output, used


def openscad(task, limit):
    model, output = task.drawing("scad"), task.drawing("dxf")
    rows = [[float(value) for value in row] + [0] for row in task.axes]
    rows[2][3] = task.cut if task.is_section() else 0
    cut = "true" if task.is_section() else "false"
    model.write_text(f'projection(cut = {cut}) multmatrix({rows + [[0, 0, 0, 1]]}) import("{task.file("stl")}");\n')
    return output, measure(["openscad", "-o", output, model], limit)


@dataclasses.dataclass
class Program:
    name: str
    source: str  # what it draws
    run: typing.Callable  # (task, limit in seconds of processor time) -> drawing, (seconds, megabytes)
    version: typing.Sequence  # a command that says it, or words


PROGRAMS = (
    Program("epura", "STEP", epura("step"), ("$EPURA", "--version")),
    Program("epura", "STL", epura("stl"), ("$EPURA", "--version")),
    Program("Open CASCADE, exact", "STEP", open_cascade("exact"), ("dpkg-query", "--show", "--showformat=${Version}", "libocct-modeling-algorithms-dev")),
    Program("Open CASCADE, polygonal", "STEP", open_cascade("polygonal"), ("dpkg-query", "--show", "--showformat=${Version}", "libocct-modeling-algorithms-dev")),
    Program("FreeCAD TechDraw", "STEP", techdraw, ("python3", "-c", "import FreeCAD; print('.'.join(FreeCAD.Version()[:3]))")),
    Program("Blender Line Art", "STL", blender, ("blender", "--version")),
    Program("OpenSCAD projection", "STL", openscad, ("openscad", "--version")),
)


def draw(program, task, limit):
    drawing, (seconds, megabytes) = program.run(task, limit)
    return Run(drawing, seconds, megabytes)


def version_of(program):
    command = [os.environ[word[1:]] if word.startswith("$E") else word for word in program.version]
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired):
        return ""
    found = re.search(r"\d+\.[\d.]*\d", done.stdout)
    return found[0] if done.returncode == 0 and found else ""
