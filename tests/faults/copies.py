# SPDX-License-Identifier: Apache-2.0
"""The other side of branch.hpp: faults that are tried by copies of a process, and the table of calls of all processes of a run."""

import os
import select
import signal
import struct
import subprocess
import tempfile
import time

CALLS = 18
ROWS = 200
LONG = 8
TABLE_BYTES = LONG + CALLS * 16 + ROWS * 2 * CALLS * LONG


def read_table(table):
    """By call: the numbers of the first and the last one of each process; the first process is the program itself."""
    rows = min(struct.unpack_from("q", table)[0], ROWS)
    words = [table[LONG + 16 * i:LONG + 16 * (i + 1)].split(b"\0")[0].decode() for i in range(CALLS)]
    numbers = struct.unpack_from(f"{rows * 2 * CALLS}q", table, LONG + CALLS * 16)
    return {word: [(numbers[2 * CALLS * row + i] + 1, numbers[2 * CALLS * row + CALLS + i]) for row in range(rows)]
            for i, word in enumerate(words)}


class Copies:
    """Runs a program; yields the number of each call that fails in a copy, how the copy ended (negative: by a signal) and what
    was said, while the folder is as the copy left it. Afterwards: `left`, the numbers that no copy could try, and how the program
    itself ended, `code` and `said`."""

    def __init__(self, folder, arguments, environment, longest):
        self.folder, self.longest = folder, longest
        self.arguments = [folder.program, *map(str, arguments)]
        self.environment = {k: v for k, v in os.environ.items() if k != "EPURA_PLUGIN_PATH"} | environment
        self.left, self.code, self.said = set(), None, ""

    def __iter__(self):
        asked, asks = os.pipe()
        answered, answers = os.pipe()
        with tempfile.TemporaryDirectory(dir=self.folder.path.parent) as kept, tempfile.TemporaryFile() as texts:
            append = os.open(f"/proc/self/fd/{texts.fileno()}", os.O_WRONLY | os.O_APPEND)
            process = subprocess.Popen(self.arguments, cwd=self.folder.path, pass_fds=(asks, answered),
                                       env=self.environment | {"EPURA_FAULT_BRANCH": f"{asks},{answered}"},
                                       stdin=subprocess.DEVNULL, stdout=append, stderr=append)
            for end in (asks, answered, append):
                os.close(end)
            lines = Lines(asked)
            try:
                yield from self.copies(lines, answers, kept, texts)
                self.code = process.wait(self.longest)
            finally:
                process.kill()
                process.wait()
                os.close(asked)
                os.close(answers)
            self.said = text_of(texts)

    def copies(self, lines, answers, kept, texts):
        while (line := lines.next(10 * self.longest)) is not None:
            word, number = line.split()
            if word == "alone":
                self.left.add(int(number))
                continue
            before = Before(self.folder.path, kept, texts)
            os.write(answers, b"y")
            child = int(self.answer(lines).split()[1])
            ended = self.answer(lines)
            hangs = ended is None
            if hangs:
                os.kill(child, signal.SIGKILL)
                ended = self.answer(lines)
            how, code = ended.split()
            if how == "again":
                self.left.add(int(number))
            else:
                yield int(number), "hangs" if hangs else int(code), text_of(texts)
            before.restore()
            os.write(answers, b"y")

    def answer(self, lines):
        """The next line of the thread that is copied: other threads tell of their calls meanwhile."""
        while (line := lines.next(self.longest)) is not None and line.startswith("alone"):
            self.left.add(int(line.split()[1]))
        return line


class Lines:
    """Lines from a pipe."""

    def __init__(self, file):
        self.file, self.rest = file, b""

    def next(self, seconds):
        """Nothing if none comes in time, or none will come."""
        end = time.monotonic() + seconds
        while b"\n" not in self.rest:
            ready, _, _ = select.select([self.file], [], [], max(0, end - time.monotonic()))
            more = os.read(self.file, 4096) if ready else b""
            if not more:
                return None
            self.rest += more
        line, self.rest = self.rest.split(b"\n", 1)
        return line.decode()


def text_of(texts):
    size = os.fstat(texts.fileno()).st_size
    return os.pread(texts.fileno(), size, 0).decode(errors="replace")


def files_below(folder):
    found = []
    for entry in os.scandir(folder):
        found += files_below(entry.path) if entry.is_dir(follow_symlinks=False) else [entry.path]
    return found


class Before:
    """The files of a folder and the words of a program before a copy of it goes on: the same files again, not others like them,
    for the program may have them open."""

    def __init__(self, folder, kept, texts):
        self.folder, self.texts = folder, texts
        self.size = os.fstat(texts.fileno()).st_size
        self.kept = {os.path.join(kept, str(i)): path for i, path in enumerate(files_below(folder))}
        for place, path in self.kept.items():
            os.link(path, place)

    def restore(self):
        for path in files_below(self.folder):
            os.unlink(path)
        for place, path in self.kept.items():
            os.rename(place, path)
        os.ftruncate(self.texts.fileno(), self.size)
