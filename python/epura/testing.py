# SPDX-License-Identifier: Apache-2.0
"""Drawings in tests.

    def test_bracket():
        assert_drawing(epura.draw("bracket.stl"), "expected/bracket.svg")

`pytest --epura-accept` writes what is expected.
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Optional, Union

from ._compare import Compared, compare, encoded
from ._drawing import Drawing

__all__ = ["assert_drawing"]


def _write(path: Path, data: bytes) -> None:
    """As a whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile(dir=path.parent, prefix=f".{path.name}.", delete=False) as file:
        file.write(data)
    try:
        os.chmod(file.name, 0o644)
        os.replace(file.name, path)
    except OSError:
        os.unlink(file.name)
        raise


def _differences(expected: Compared, drawing: Drawing, tolerance: float, suffix: str) -> Optional[str]:
    """What to say, with the drawing and a page in a folder of their own."""
    found = compare(expected, drawing, tolerance)
    if found:
        return None
    folder = Path(tempfile.mkdtemp(prefix="epura-"))
    found.save(folder / "differences.html")
    (folder / f"actual{suffix}").write_bytes(encoded(drawing, suffix))
    return f"{found.words}\nsee {folder / 'differences.html'} and actual{suffix} beside it"


def assert_drawing(drawing: Drawing, expected: Union[str, "os.PathLike[str]"], tolerance: float = 0.001,
                   accept: Optional[bool] = None) -> None:
    """Raises AssertionError unless the drawing is the expected one: a file .svg, .pdf or .json, whose relative path
    starts at the test's folder under pytest. Lines within `tolerance` mm count as equal. `accept`: write the file
    instead; by default with `--epura-accept`.
    """
    import pytest_epura

    path = pytest_epura.folder() / expected
    suffix = path.suffix.lower()
    data = encoded(drawing, suffix)
    missing = not path.exists()
    words = None if missing else _differences(path, drawing, tolerance, suffix)
    if not missing and words is None:
        return
    if pytest_epura.accepts() if accept is None else accept:
        _write(path, data)
        return
    if missing:
        raise AssertionError(f"{path}: there is no expected drawing; pytest --epura-accept writes it")
    raise AssertionError(f"{path}: the drawing has changed\n{words}\npytest --epura-accept makes it the expected one")
