#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a batch survives:  tests/batch_trials.py EPURA [--kills N] [--parts N] [--listed N]

kill -9 at random moments, of the batch or of its whole group; a full disk (as root, on a file system of its own); two
batches in one folder; very many files in a list; names in any characters. After each, every output is whole, the
manifest is readable, and the same command completes the rest and repeats no finished job. The usual numbers are for
ctest; the trial at full size is --kills 50 --parts 300 --listed 100000.
"""
import argparse
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

WORKERS = 2
AT_ONCE = 5 if "EPURA_AT_LENGTH" in os.environ else 2
failures = []


def check(what, is_right, found=""):
    if not is_right:
        failures.append(what)
        print(f"FAILED: {what}: {found}")


def block(height):
    corners = [(x, y, z) for z in (0, height) for x, y in ((0, 0), (9, 0), (9, 9), (0, 9))]
    faces = [(4, 3, 2, 1), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8)]
    return ("".join(f"v {x} {y} {z}\n" for x, y, z in corners) +
            "".join("f " + " ".join(map(str, face)) + "\n" for face in faces))


def make_parts(folder, count):
    folder.mkdir()
    for i in range(count):
        (folder / f"m{i}.obj").write_text(block(1 + i / 10))


def command(epura, out, sources=("parts",)):
    return [epura, "batch", *sources, "-o", f"{out}/{{name}}.svg", "--projection", "cabinet", "--workers", str(WORKERS)]


def run(arguments, **options):
    ran = subprocess.run(arguments, capture_output=True, text=True, **options)
    return ran.returncode, ran.stdout, ran.stderr


def outputs(folder):
    folder = Path(folder)
    return {path.name: path.read_bytes() for path in folder.glob("*.svg")} if folder.is_dir() else {}


def records(folder):
    """The lines of the manifest; the last one may be cut off."""
    manifest = Path(folder) / "epura-batch.jsonl"
    lines = manifest.read_bytes().split(b"\n")[:-1] if manifest.exists() else []
    return [json.loads(line) for line in lines]


def counted(text):
    numbers = re.fullmatch(r"(\d+) drawn, (?:(\d+) unchanged, )?(\d+) failed\n", text)
    return tuple(int(number or 0) for number in numbers.groups()) if numbers else (-1, -1, -1)


def workers_left():
    """Processes that work in this folder."""
    here = os.getcwd()
    for process in Path("/proc").glob("[0-9]*"):
        try:
            if os.readlink(process / "cwd") == here and (process / "comm").read_text().startswith("epura"):
                return True
        except OSError:
            pass
    return False


def complete(epura, what, expected, parts):
    """The batch that follows an interrupted one."""
    found, made = records("out"), outputs("out")
    good = {record["output"] for record in found if record["code"] == 0}
    damaged = [name for name, data in made.items() if data != expected[name]]
    check(f"{what}: outputs are whole", not damaged, damaged[:3])
    check(f"{what}: what the manifest says is there", good <= {f"out/{name}" for name in made}, len(good - set(made)))
    check(f"{what}: at most the running jobs are lost", len(made) - len(good) <= WORKERS, (len(made), len(good)))
    code, text, errors = run(command(epura, "out"))
    check(f"{what}: is completed", code == 0, errors)
    check(f"{what}: no finished job is repeated", counted(text) == (parts - len(good), len(good), 0), (text, len(good)))
    check(f"{what}: makes the same drawings", outputs("out") == expected)


def try_kills(epura, expected, parts, kills, seconds):
    for number in range(kills):
        shutil.rmtree("out", ignore_errors=True)
        batch = subprocess.Popen(command(epura, "out"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                 start_new_session=True)
        time.sleep(random.uniform(0, seconds))
        if random.random() < 0.5:
            batch.kill()
        else:
            try:
                os.killpg(batch.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        batch.wait()
        while workers_left():
            time.sleep(0.001)
        complete(epura, f"kill {number}", expected, parts)
        strays = [path.name for path in Path("out").iterdir() if path.suffix not in (".svg", ".jsonl")]
        check(f"kill {number}: leaves few files behind", len(strays) <= WORKERS, strays)
    print(f"{kills} kills of a batch of {parts} that takes {seconds:.2f} s")


def try_full_disk(epura, expected, parts):
    shutil.rmtree("out", ignore_errors=True)
    os.mkdir("out")
    half = sum(map(len, expected.values())) // 2 // 1024
    if os.geteuid() != 0 or run(["mount", "-t", "tmpfs", "-o", f"size={half}k", "none", "out"])[0] != 0:
        print("no full disk: only root can mount a file system here")
        return
    try:
        code, _, errors = run(command(epura, "out"))
        check("full disk: is an error", code in (1, 4), code)
        check("full disk: is named", "No space left on device" in errors, errors[:300])
        check("full disk: is no crash", "crashes" not in errors, errors[:300])
        some = outputs("out")
        check("full disk: some drawings are made", 0 < len(some) < parts, len(some))
        run(["mount", "-o", "remount,size=64m", "out"])
        complete(epura, "full disk", expected, parts)
    finally:
        run(["umount", "-l", "out"])
    print("a full disk")


def try_two_at_once(epura, expected, parts):
    for number in range(AT_ONCE):
        shutil.rmtree("out", ignore_errors=True)
        both = [subprocess.Popen(command(epura, "out"), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                for _ in range(2)]
        told = [batch.communicate() + (batch.returncode,) for batch in both]
        codes = sorted(code for _, _, code in told)
        check("two at once: one succeeds, the other too or is refused", codes in ([0, 0], [0, 4]), told)
        for _, errors, code in told:
            check("two at once: the refusal is told", code == 0 or "another batch is writing to it" in errors, errors)
        complete(epura, f"two at once, {number}", expected, parts)
    print("two batches in one folder")


def try_list(epura, count):
    """One model under very many names, each of which is drawn."""
    os.mkdir("many")
    Path("many/m.obj").write_text(block(1))
    for i in range(count - 1):
        linked = i - i % 50000  # file systems allow some 65000 links to a file
        os.link(f"many/{linked}.obj", f"many/{i}.obj") if i > linked else shutil.copy("many/m.obj", f"many/{i}.obj")
    listed = "\0".join(f"many/{name}" for name in sorted(os.listdir("many")))
    for what, drawn in (("first", (count, 0, 0)), ("second", (0, count, 0))):
        begin = time.monotonic()
        code, text, errors = run(command(epura, "listed", ["-"]), input=listed)
        check(f"{count} files, {what} time", code == 0 and counted(text) == drawn, (text, errors[:300]))
        print(f"{count} files listed, {what} time: {time.monotonic() - begin:.1f} s")
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    check("memory grows by less than 20 kB a file", memory < 200 + count * 0.02, memory)


def try_names(epura):
    names = ["new\nline", "tab\there", "q\"uote'", "b\\slash", "ünïcode ✓ 図面", "a" * 200, " blanks ", "-o", "%41%s",
             "\u202eright to left", "<b>&amp;", "{name}", "[a]*?", "$(ran)", "#1", "e\u0301 and é"]
    os.mkdir("names")
    for name in names:
        Path(f"names/{name}.obj").write_text(block(1))
    raw = os.fsencode("names") + b"/latin-\xe9.obj"
    with open(raw, "w") as file:
        file.write(block(1))
    listed = b"\0".join([*(os.fsencode(f"names/{name}.obj") for name in names), raw])
    for what, sources, given in (("in a folder", ["names"], b""), ("in a list", ["-"], listed)):
        # A name that is not UTF-8 is drawn each time: JSON has no text for it.
        for drawn in ((len(names) + 1, 0, 0), (1, len(names), 0)):
            ran = subprocess.run(command(epura, f"out {what}", sources) + ["--report", "r.html", "--junit", "r.xml"],
                                 input=given, capture_output=True)
            check(f"names {what}", ran.returncode == 0 and counted(ran.stdout.decode()) == drawn,
                  (ran.stdout, ran.stderr))
        made = {path.stem for path in Path(f"out {what}").glob("*.svg")}
        check(f"names {what} are those of the drawings", set(names) <= made, set(names) - made)
        for line in Path(f"out {what}/epura-batch.jsonl").read_bytes().splitlines():
            json.loads(line)
        check("the report has no markup of names", b"<b>&amp;" not in Path("r.html").read_bytes())
    print("names in any characters")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("epura")
    parser.add_argument("--kills", type=int, default=5)
    parser.add_argument("--parts", type=int, default=120)
    parser.add_argument("--listed", type=int, default=2000)
    options = parser.parse_args()
    epura = os.path.abspath(options.epura)
    seed = random.randrange(10**6)
    random.seed(seed)
    print(f"seed {seed}")
    with tempfile.TemporaryDirectory() as scratch:
        os.chdir(scratch)
        make_parts(Path("parts"), options.parts)
        begin = time.monotonic()
        code, text, errors = run(command(epura, "out"))
        seconds = time.monotonic() - begin
        check("the undisturbed batch", code == 0 and counted(text) == (options.parts, 0, 0), (text, errors))
        expected = outputs("out")
        try_kills(epura, expected, options.parts, options.kills, seconds)
        try_two_at_once(epura, expected, options.parts)
        try_full_disk(epura, expected, options.parts)
        try_names(epura)
        try_list(epura, options.listed)
        os.chdir("/")
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
