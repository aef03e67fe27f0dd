# SPDX-License-Identifier: Apache-2.0
"""The module against what is known of a cube, and against the program."""
import os
import re
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import epura

SAMPLES = Path(os.environ["EPURA_SAMPLES"])
VERTICES = np.array([[x, y, z] for z in (0, 9) for x, y in ((0, 0), (9, 0), (9, 9), (0, 9))], dtype=float)
FACES = np.array([[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])


def test_isometric_cube_has_nine_equal_visible_edges():
    view = epura.draw(VERTICES, FACES, scale=1).views[0]
    assert view.visible.sum() == 9 and len({tuple(sorted(edge)) for edge in view.edge[view.visible]}) == 9
    lengths = np.linalg.norm(view.segments[view.visible, 1] - view.segments[view.visible, 0], axis=1)
    assert lengths == pytest.approx(9 * np.sqrt(2 / 3), abs=1e-3)  # foreshortening of ISO 5456-3


def test_lines_lie_where_the_matrix_says():
    view = epura.draw(VERTICES, FACES, projection="two-point").views[0]
    ends = VERTICES[view.edge]
    points = ends[:, :1] + view.t[..., None] * (ends[:, 1:] - ends[:, :1])
    pages = np.concatenate([points, np.ones(points.shape[:2] + (1,))], axis=2) @ view.world_to_page.T
    assert pages[..., :2] / pages[..., 3:] == pytest.approx(view.segments, abs=1e-3)


def test_arrays_are_borrowed_read_only_and_outlive_the_drawing():
    segments = epura.draw(VERTICES, FACES).views[0].segments
    before = segments.copy()
    assert not segments.flags.owndata and not segments.flags.writeable
    for _ in range(3):
        epura.draw(VERTICES, FACES, projection="front")
    assert (segments == before).all()


@pytest.mark.parametrize("extension", ["svg", "pdf", "png", "json", "dxf"])
def test_files_are_those_of_the_program(tmp_path, extension):
    model = SAMPLES / "models" / "bracket.obj"
    by_program = tmp_path / f"program.{extension}"
    subprocess.run([os.environ["EPURA_PROGRAM"], "draw", model, "--projection", "isometric", "-o", by_program], check=True,
                   capture_output=True)
    drawing = epura.draw(model)
    by_module = tmp_path / f"module.{extension}"
    assert drawing.save(by_module) == [str(by_module)]
    if extension != "json":  # which names stages and their times
        assert by_module.read_bytes() == by_program.read_bytes()


def test_bytes_are_those_of_saved_files(tmp_path):
    drawing = epura.draw(VERTICES, FACES)
    drawing.save(tmp_path / "a.svg")
    assert drawing.to_svg() == drawing._repr_svg_() == (tmp_path / "a.svg").read_text()
    assert drawing.to_pdf().startswith(b"%PDF") and drawing.to_png(dpi=50).startswith(b"\x89PNG")


def test_objects_lists_and_mixed_faces_are_the_same_drawing():
    expected = epura.draw(VERTICES, FACES).to_svg()
    assert epura.draw(SimpleNamespace(vertices=VERTICES, faces=FACES)).to_svg() == expected
    assert epura.draw(VERTICES.tolist(), FACES.tolist()).to_svg() == expected
    mixed = FACES[:-1].tolist() + [[3, 0, 4], [3, 4, 7]]
    assert epura.draw(VERTICES, mixed).views[0].visible.sum() == 9


def test_views_and_parameters():
    assert [v.projection for v in epura.draw(VERTICES, FACES, views=["front", "top"]).views] == ["front", "top"]
    narrow = epura.draw(VERTICES, FACES, projection="cabinet", parameters={"angle": 30})
    assert narrow.to_svg() != epura.draw(VERTICES, FACES, projection="cabinet").to_svg()


@pytest.mark.parametrize("call, kind, place", [
    (lambda: epura.draw(VERTICES[:, :2], FACES), epura.InputError, "vertices"),
    (lambda: epura.draw(VERTICES, FACES + 0.5), epura.InputError, "faces"),
    (lambda: epura.draw(VERTICES, FACES + 1), epura.InputError, "models[0].polygons.faces[1]"),
    (lambda: epura.draw(3), epura.InputError, "model"),
    (lambda: epura.draw(VERTICES, FACES, hidden="dotted"), epura.InputError, "hidden"),
    (lambda: epura.draw(VERTICES, FACES, views=["front"], parameters={"angle": 1}), epura.InputError, "parameters"),
])
def test_errors_have_place_and_hint(call, kind, place):
    with pytest.raises(kind) as caught:
        call()
    assert caught.value.place == place and caught.value.hint and caught.value.hint in str(caught.value)


def test_an_unknown_projection_and_a_missing_file():
    with pytest.raises(epura.Error, match="isometrik"):
        epura.draw(VERTICES, FACES, projection="isometrik")
    with pytest.raises(epura.InputError, match="absent.obj"):
        epura.draw("absent.obj")
    with pytest.raises(epura.OutputError):
        epura.draw(VERTICES, FACES).save("/proc/absent/a.svg")


def grid(n):
    """A wavy surface with 2 n^2 triangles, which takes seconds."""
    x, y = np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0), indexing="ij")
    points = np.stack([x, y, 3 * np.sin(x) * np.cos(y)], axis=-1).reshape(-1, 3)
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    return points, np.concatenate([np.stack([a, a + n + 1, a + n + 2], 1), np.stack([a, a + n + 2, a + 1], 1)])


def test_ctrl_c_stops_and_progress_is_told():
    points, faces = grid(500)
    told, sent = [], []

    def progress(stage, done):
        told.append((stage, done))
        if not sent:
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        epura.draw(points, faces, progress=progress)
    assert time.monotonic() - sent[0] < 2  # 0.2 s on an idle machine
    assert told and all(0 <= done <= 1 for _, done in told)


def test_other_threads_run_meanwhile():
    points, faces = grid(120)
    thread = threading.Thread(target=epura.draw, args=(points, faces))
    thread.start()
    turns = 0
    while thread.is_alive():
        turns += 1
        time.sleep(0.001)
    assert turns > 10


def test_errors_of_progress_stop_the_drawing():
    def progress(stage, done):
        raise LookupError(stage)

    with pytest.raises(LookupError):
        epura.draw(*grid(300), progress=progress)


def test_types_are_sound():
    mypy = pytest.importorskip("mypy.api")
    package = Path(epura.__file__).parent
    text, _, status = mypy.run(["--ignore-missing-imports", "--cache-dir", os.devnull, str(package)])
    assert status == 0, text


def test_blocks_of_the_page_run(tmp_path, monkeypatch, capsys):
    page = (SAMPLES.parent / "docs" / "python.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```$", page, re.M | re.S)
    (tmp_path / "samples").symlink_to(SAMPLES)
    monkeypatch.chdir(tmp_path)
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), {})
    assert blocks and (tmp_path / "bracket.pdf").exists()


if __name__ == "__main__":
    sys.exit(pytest.main([__file__]))
