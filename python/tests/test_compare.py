# SPDX-License-Identifier: Apache-2.0
"""compare, and drawings in tests."""
import os
import subprocess
import sys
from pathlib import Path

import pytest

import epura
from shapes import FACES, VERTICES

PROJECT = """
import numpy as np
import epura
from epura.testing import assert_drawing

VERTICES = np.array([[x, y, z] for z in (0, HEIGHT) for x, y in ((0, 0), (9, 0), (9, 9), (0, 9))], dtype=float)
FACES = np.array([[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])

def test_block():
    assert_drawing(epura.draw(VERTICES, FACES, scale=1), "expected/block.svg")
"""


def higher(height):
    vertices = VERTICES.copy()
    vertices[4:, 2] = height
    return epura.draw(vertices, FACES, projection="front", scale=1, size="A4")


def test_equal_and_different(tmp_path):
    assert epura.compare(higher(9), higher(9))
    found = epura.compare(higher(9), higher(10))
    assert not found and {one["change"] for one in found.differences} <= {"moved", "added", "removed"}
    assert found.words.splitlines()[-1] in repr(found)
    found.save(tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text()
    assert page.startswith("<!DOCTYPE html>") and "Content-Security-Policy" in page
    assert epura.compare(higher(9), higher(9.0004), tolerance=0.01)


def test_files_text_and_drawings(tmp_path):
    drawing = higher(9)
    for extension in ("svg", "pdf", "json"):
        file = tmp_path / f"a.{extension}"
        drawing.save(file)
        assert epura.compare(file, drawing) and epura.compare(drawing, str(file))
        assert not epura.compare(file, higher(11))
    assert epura.compare(drawing.to_svg(), drawing)
    two = epura.Scene(models=[epura.Model(VERTICES, FACES)], views=["front", epura.View("top", sheet=2)],
                      sheets=[epura.Sheet("A4"), epura.Sheet("A4")])
    assert epura.compare(epura.draw(two), epura.draw(two))


def test_errors(tmp_path):
    with pytest.raises(epura.InputError, match="absent.svg"):
        epura.compare("absent.svg", higher(9))
    (tmp_path / "a.svg").write_text("<svg")
    with pytest.raises(epura.InputError):
        epura.compare(tmp_path / "a.svg", higher(9))
    with pytest.raises(epura.InputError, match="cannot be compared"):
        epura.compare(higher(9), "a.dxf")
    with pytest.raises(epura.InputError, match="tolerance"):
        epura.compare(higher(9), higher(9), tolerance=-1)


def run(folder, *arguments):
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "TMPDIR": str(folder / "tmp")}
    (folder / "tmp").mkdir(exist_ok=True)
    ran = subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *arguments], cwd=folder,
                         env=environment, capture_output=True, text=True)
    return ran.returncode, ran.stdout + ran.stderr


def test_a_project_of_its_own(tmp_path):
    """As a user would: accept, pass, fail after a change, accept it."""
    tests = tmp_path / "tests"
    tests.mkdir()
    (tests / "test_block.py").write_text(PROJECT.replace("HEIGHT", "9"))
    code, text = run(tmp_path)
    assert code == 1 and "there is no expected drawing; pytest --epura-accept writes it" in text
    assert not (tests / "expected").exists()
    assert run(tmp_path, "--epura-accept")[0] == 0
    expected = tests / "expected" / "block.svg"
    first = expected.read_text()
    assert run(tmp_path)[0] == 0

    (tests / "test_block.py").write_text(PROJECT.replace("HEIGHT", "12"))
    code, text = run(tmp_path)
    assert code == 1 and "the drawing has changed" in text and "moved" in text
    pages = list((tmp_path / "tmp").glob("epura-*/differences.html"))
    assert len(pages) == 1 and (pages[0].parent / "actual.svg").exists()
    assert expected.read_text() == first
    assert run(tmp_path, "--epura-accept")[0] == 0 and expected.read_text() != first
    assert run(tmp_path)[0] == 0
    assert [path.name for path in expected.parent.iterdir()] == ["block.svg"]


def test_outside_of_pytest(tmp_path):
    from epura.testing import assert_drawing

    file = tmp_path / "a.pdf"
    with pytest.raises(AssertionError, match="no expected drawing"):
        assert_drawing(higher(9), file)
    assert_drawing(higher(9), file, accept=True)
    assert_drawing(higher(9), file)
    with pytest.raises(AssertionError, match="has changed"):
        assert_drawing(higher(12), Path(file))
    with pytest.raises(epura.InputError, match="cannot be compared"):
        assert_drawing(higher(9), tmp_path / "a.png")
