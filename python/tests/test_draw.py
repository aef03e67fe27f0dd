# SPDX-License-Identifier: Apache-2.0
"""The module against what is known of a cube, and against the program."""
import base64
import os
import re
import signal
import subprocess
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import epura
from shapes import FACES, SAMPLES, VERTICES, grid


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
    before, data = drawing._repr_html_().split('src="data:image/svg+xml;base64,')
    assert base64.b64decode(data[:data.index('"')]).decode() == drawing.to_svg() and "isometric" in before
    assert drawing.to_pdf().startswith(b"%PDF") and drawing.to_png(dpi=50).startswith(b"\x89PNG")


def test_views_and_parameters():
    assert [v.projection for v in epura.draw(VERTICES, FACES, views=["front", "top"]).views] == ["front", "top"]
    narrow = epura.draw(VERTICES, FACES, projection="cabinet", parameters={"angle": 30})
    assert narrow.to_svg() != epura.draw(VERTICES, FACES, projection="cabinet").to_svg()


@pytest.mark.parametrize("call, kind, place", [
    (lambda: epura.draw(VERTICES[:, :2], FACES), epura.InputError, "models[0].vertices"),
    (lambda: epura.draw(VERTICES, FACES + 0.5), epura.InputError, "models[0].faces"),
    (lambda: epura.draw(VERTICES, FACES + 1), epura.InputError, "models[0].faces[1]"),
    (lambda: epura.draw(3), epura.InputError, "models[0]"),
    (lambda: epura.draw(VERTICES, FACES, hidden="dashes"), epura.InputError, "views[0].hidden"),
    (lambda: epura.draw(VERTICES, FACES, views=["front"], parameters={"angle": 1}), epura.InputError, "parameters"),
    (lambda: epura.draw(VERTICES, FACES, views=["front"], projection="top"), epura.InputError, "projection"),
    (lambda: epura.draw("a.toml", views=["front"]), epura.InputError, "views"),
    (lambda: epura.draw(VERTICES, FACES, sheet={"sise": "A4"}), epura.InputError, "sheets[0].sise"),
    (lambda: epura.draw(VERTICES, FACES, sheet="A4"), epura.InputError, "sheet"),
])
def test_errors_have_place_and_hint(call, kind, place):
    with pytest.raises(kind) as caught:
        call()
    assert caught.value.place == place and caught.value.hint and caught.value.hint in str(caught.value)


@pytest.mark.parametrize("words, options", [
    (["--views", "front,top", "--dimensions", "auto", "--third-angle", "--owner", "Works", "--scale", "1:2"],
     {"views": ["front", "top"], "dimensions": "auto", "angle": "third", "owner": "Works", "scale": "1:2"}),
    (["--projection", "front", "--section", "0,0,5:0,-1,0", "--hatch", "steel"],
     {"projection": "front", "section": "0,0,5:0,-1,0", "hatch": "steel"}),
    (["--edges", "contour", "--unit", "in", "--frame", "plain"],
     {"edges": ["contour"], "unit": "in", "frame": "plain"}),
    (["--views", "front,top", "--dimensions", "hole-table", "--parts-list"],
     {"views": "front,top", "dimensions": "hole-table", "parts_list": True}),
    (["--projection", "front", "--dimensions", "auto", "--arrangement", "chain", "--explode", "1"],
     {"projection": "front", "dimensions": "auto", "arrangement": "chain", "explode": 1})])
def test_options_are_those_of_the_program(tmp_path, words, options):
    model = SAMPLES / "models" / "flange.obj"
    by_program = tmp_path / "program.svg"
    subprocess.run([os.environ["EPURA_PROGRAM"], "draw", model, *words, "-o", by_program], check=True, capture_output=True)
    epura.draw(model, **options).save(tmp_path / "module.svg")
    assert (tmp_path / "module.svg").read_bytes() == by_program.read_bytes()


def test_a_misspelt_option_is_told_with_the_known_ones():
    with pytest.raises(epura.InputError) as near:
        epura.draw(VERTICES, FACES, dimension="auto")
    assert near.value.place == "dimension" and near.value.hint == "did you mean 'dimensions'?"
    with pytest.raises(epura.InputError, match="known are .*edges.*owner.*unit"):
        epura.draw(VERTICES, FACES, zzzzzz=1)
    for options in ({"dimensions": "all"}, {"section": "y"}, {"views": ["front", "top"], "section": "0,0,0:0,-1,0"},
                    {"arrangement": "chain"}):
        with pytest.raises(epura.InputError) as wrong:
            epura.draw(VERTICES, FACES, **options)
        assert wrong.value.place in options and wrong.value.hint
    with pytest.raises(epura.InputError) as with_scene:
        epura.draw(epura.Scene(models=[epura.Model(VERTICES, FACES)]), edges=["contour"])
    assert with_scene.value.place == "edges"


def test_an_unknown_projection_and_a_missing_file():
    with pytest.raises(epura.Error, match="isometrik"):
        epura.draw(VERTICES, FACES, projection="isometrik")
    with pytest.raises(epura.InputError, match="absent.obj"):
        epura.draw("absent.obj")
    with pytest.raises(epura.OutputError):
        epura.draw(VERTICES, FACES).save("/proc/absent/a.svg")


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
    assert time.monotonic() - sent[0] < 1.5
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


@pytest.mark.parametrize("moment", [0, 0.3, 0.7, 1.2, 2])
def test_ctrl_c_is_fast_at_any_moment(moment):
    points, faces = grid(500)
    begin = time.monotonic()
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        threading.Timer(moment, interrupt).start()
        while time.monotonic() < begin + 60:
            epura.draw(points, faces)
    late = time.monotonic() - sent[0]
    print(f"{late:.3f} s after Ctrl-C")
    assert late < 1.5  # 0.2 s, see docs/python.md, on a machine that does nothing else


def test_progress_is_a_bar(capsys):
    pytest.importorskip("tqdm")
    epura.draw(*grid(200), progress=True)
    shown = re.findall(r"([\w ]+): +(\d+)%\|", capsys.readouterr().err)
    assert shown
    stages = [stage for stage, _ in shown]
    # One bar for each stage, which grows.
    for stage in set(stages):
        parts = [int(part) for name, part in shown if name == stage]
        assert parts == sorted(parts) and parts.count(0) <= 1


def test_blocks_of_the_page_run(tmp_path, monkeypatch):
    page = (SAMPLES.parent / "docs" / "python.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```$", page, re.M | re.S)
    (tmp_path / "samples").symlink_to(SAMPLES)
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)
    assert len(blocks) >= 5 and (tmp_path / "bracket.pdf").exists()


def test_annotations_are_those_of_the_program():
    scene = epura.Scene(models=[epura.Model(VERTICES, FACES)], views=["front", "top"],
                        dimensions=[epura.Dimension(type="overall")])
    found = epura.draw(scene).annotations()
    assert [one["value"] for one in found["dimensions"]] == [9, 9, 9]
    assert len({one["id"] for one in found["dimensions"]}) == 3
    assert epura.draw(VERTICES, FACES).annotations() == {}
