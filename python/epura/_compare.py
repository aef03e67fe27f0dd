# SPDX-License-Identifier: Apache-2.0
"""Visible differences between drawings."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, Dict, List, Tuple, Union

from . import _core
from ._drawing import Drawing
from ._errors import InputError

Compared = Union[Drawing, str, "os.PathLike[str]"]


class Comparison:
    """What `compare` has found. It is true if there is no difference."""

    def __init__(self, is_same: bool, words: str, facts: str, page: str) -> None:
        self.is_same = is_same
        self.words = words
        self.page = page
        self._facts = facts

    @property
    def differences(self) -> List[Dict[str, Any]]:
        """One dictionary each, as `epura compare --json` writes them (docs/reports.md)."""
        found: List[Dict[str, Any]] = json.loads(self._facts)["differences"]
        return found

    def save(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Writes a page (HTML) that shows the differences."""
        Path(file).write_text(self.page or f"<!DOCTYPE html><title>Same</title><pre>{self.words}</pre>", "utf-8")

    def __bool__(self) -> bool:
        return self.is_same

    def __str__(self) -> str:
        return self.words

    def __repr__(self) -> str:
        return f"<epura.Comparison: {self.words.splitlines()[-1] if self.words else 'same'}>"


def encoded(drawing: Drawing, extension: str) -> bytes:
    """The bytes of a file that can be compared. Raises InputError for other formats and several sheets."""
    if extension == ".pdf":
        return drawing.to_pdf()
    if extension not in (".svg", ".json"):
        raise InputError(f"'{extension}' cannot be compared", "expected", "drawings are compared as .svg, .pdf or .json")
    if drawing.sheets > 1:
        raise InputError(f"the drawing has {drawing.sheets} sheets, a file of {extension} has one", "expected",
                         "compare them as .pdf")
    return (drawing.to_svg() if extension == ".svg" else drawing.to_json()).encode()


def _file(compared: Compared, like: str) -> Tuple[str, bytes]:
    if isinstance(compared, Drawing):
        return f"drawing{like}", encoded(compared, like)
    if isinstance(compared, str) and compared.lstrip().startswith("<"):
        return "drawing.svg", compared.encode()
    try:
        return os.fspath(compared), Path(compared).read_bytes()
    except OSError as error:
        raise InputError(f"{os.fspath(compared)}: {error.strerror}", os.fspath(compared)) from None


def _format_of(*compared: Compared) -> str:
    """That of a file among them; several sheets are compared as PDF."""
    for one in compared:
        if not isinstance(one, Drawing):
            return ".svg" if isinstance(one, str) and one.lstrip().startswith("<") else Path(one).suffix.lower()
    return ".pdf" if any(isinstance(one, Drawing) and one.sheets > 1 for one in compared) else ".svg"


def compare(before: Compared, after: Compared, tolerance: float = 0.001) -> Comparison:
    """Compares two drawings: a `Drawing`, the path of a file that epura has written (.svg, .pdf, .json), or SVG as text.

    Lines are compared as sets of points: how they are cut, ordered and numbered does not matter; those within
    `tolerance` mm of each other count as equal. Raises InputError.
    """
    like = _format_of(before, after)
    return Comparison(*_core.compare(*_file(before, like), *_file(after, like), tolerance))
