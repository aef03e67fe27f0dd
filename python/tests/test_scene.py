# SPDX-License-Identifier: Apache-2.0
"""Scenes against scene files with the same words."""
import datetime
import json
import os
import shutil
import subprocess

import numpy as np
import pytest

import epura
from shapes import FACES, SAMPLES, VERTICES

FLANGE = SAMPLES / "models" / "flange.obj"
FILE = """
views = ["front"]
[[model]]
file = "flange.obj"
name = "flange"
[[style]]
match = "flange"
hatch = "steel"
[[view]]
projection = "top"
name = "cut"
section = "A"
[[view]]
projection = {name = "cabinet", angle = 30}
edges = ["contour", "crease"]
[[section]]
name = "A"
point = [0, 0, 5]
normal = [0, 0, 1]
[[dimension]]
type = "overall"
view = "front"
[[note]]
text = "DEBURR"
[[revision]]
revision = "B"
text = "thicker"
date = 2026-11-21
[parts_list]
balloons = false
[[sheet]]
size = "A3"
scale = 0.5
[sheet.title_block]
title = "Flange"
"""


def scene():
    return epura.Scene(
        models=[epura.Model(FLANGE, name="flange")],
        styles=[epura.Style("flange", hatch="steel")],
        views=["front", epura.View("top", name="cut", section="A"),
               epura.View({"name": "cabinet", "angle": 30}, edges=["contour", "crease"])],
        sections=[epura.Section("A", point=(0, 0, 5), normal=np.array([0, 0, 1]))],
        dimensions=[epura.Dimension(type="overall", view="front")],
        notes=[epura.Note("DEBURR")],
        revisions=[epura.Revision("B", text="thicker", date=datetime.date(2026, 11, 21))],
        parts_list=epura.PartsList(balloons=False),
        sheets=[epura.Sheet("A3", scale=0.5, title_block={"title": "Flange"})])


def test_a_scene_is_its_file(tmp_path):
    file = tmp_path / "scene.toml"
    file.write_text(FILE)
    shutil.copy(FLANGE, tmp_path)
    assert epura.draw(scene()).to_svg() == epura.draw(file).to_svg()
    by_program = tmp_path / "program.svg"
    subprocess.run([os.environ["EPURA_PROGRAM"], "draw", file, "-o", by_program], check=True, capture_output=True)
    assert by_program.read_text() == epura.draw(scene()).to_svg()


def test_scene_files_name_files_below_them(tmp_path):
    file = tmp_path / "scene.toml"
    file.write_text(f"[[model]]\nfile = '{FLANGE}'\n")
    with pytest.raises(epura.InputError):
        epura.draw(file)
    assert len(epura.draw(file, allow_outside=True).views) == 1


def test_dictionaries_say_the_same():
    plain = epura.Scene(models=[{"file": FLANGE}], views=[{"projection": "front", "hidden": "none"}],
                        sheets=[{"size": "A4", "scale": "1:2"}])
    parts = epura.Scene(models=[FLANGE], views=[epura.View("front", hidden="none")],
                        sheets=[epura.Sheet("A4", scale="1:2")])
    assert epura.draw(plain).to_svg() == epura.draw(parts).to_svg()


def test_models_in_memory_and_dimensions():
    other = VERTICES + [20, 0, 0]
    drawing = epura.draw(epura.Scene(
        models=[epura.Model(VERTICES, FACES, name="left"), epura.Model(other, FACES, name="right")], views=["front"],
        dimensions=[epura.Dimension(type="linear", direction="horizontal", from_=("left", 0), to=("right", 1))],
        sheets=[epura.Sheet(scale=1)]))
    assert set(np.unique(drawing.views[0].model)) == {0, 1}
    assert "dimensions" in {layer.name.split("/")[-1] for layer in drawing.layers()}
    texts = epura.draw(epura.Scene(models=[epura.Model(VERTICES, FACES)], views=["front"],
                                   dimensions=[epura.Dimension(type="overall")])).to_svg()
    assert texts.count("<path") > 10


def test_views_state_their_error():
    view = epura.draw(SAMPLES / "models" / "flange.obj", views=["top"]).views[0]
    assert set(view.error_terms) >= {"surface", "hiding"} and view.error == pytest.approx(
        sum(mm for mm, by in view.error_terms.values() if by in ("bound", "measured", "estimated")))
    error = epura.draw(SAMPLES / "models" / "flange.obj", views=["top"], max_error=2 * view.error).views[0].error
    assert error <= 2 * view.error
    with pytest.raises(epura.InputError, match="max"):
        epura.draw(SAMPLES / "models" / "flange.obj", views=["top"], max_error=1e-3)


def test_drawings_have_layers_and_arcs():
    drawing = epura.draw(SAMPLES / "models" / "flange.obj", views=["top"], arcs=0.01)
    arcs = drawing.views[0].arcs
    circles = [arc for arc in arcs if arc.end - arc.start == pytest.approx(2 * np.pi)]
    assert circles and all(np.hypot(*arc.u) == pytest.approx(np.hypot(*arc.v)) for arc in circles)
    layer = next(layer for layer in drawing.layers() if layer.name == "top/visible")
    assert layer.width > 0 and all(stroke.shape[1] == 2 for stroke in layer.strokes)
    assert json.loads(drawing.to_json())["views"][0]["name"] == "top"
    assert drawing.to_dxf().endswith("0\nEOF\n")


@pytest.mark.parametrize("change, place, words", [
    ({"views": [epura.View("front", hidden="dotted")]}, "views[0].hidden", "dashed"),
    ({"views": ["front", {"projektion": "top"}]}, "views[1].projektion", "projection"),
    ({"views": [epura.View("front", section="B")]}, "views[0].section", "there is no section 'B'"),
    ({"sections": [epura.Section("A", point=(1, 2))]}, "sections[0].point", "3 numbers"),
    ({"sections": [{"point": (1, 2, 3)}]}, "sections[0]", "lacks 'name'"),
    ({"sheets": [epura.Sheet("A9")]}, "sheets[0].size", "A4"),
    ({"sheets": [epura.Sheet(scale=float("nan"))]}, "sheets[0].scale", "finite"),
    ({"models": []}, "scene", "names no model"),
    ({"models": [FLANGE, 7]}, "models[1]", "is of type int"),
    ({"dimensions": [epura.Dimension(type="linear", from_=(0, 1))]}, "dimensions[0]", "lacks 'to'"),
    ({"notes": [epura.Note(b"x")]}, "notes[0].text", "is of type bytes"),
    ({"styles": [epura.Style("*", colour=object())]}, "styles[0].colour", "is of type object"),
])
def test_errors_name_their_place(change, place, words):
    arguments = {"models": [FLANGE], **change}
    with pytest.raises(epura.InputError) as caught:
        epura.draw(epura.Scene(**arguments))
    assert caught.value.place == place
    assert words in str(caught.value)


def test_every_section_of_scene_files_is_a_member():
    """The classes are made from the tables; members of a scene are written by hand."""
    from dataclasses import fields

    from epura import _parts, _scene

    sections = {member.name for member in fields(epura.Scene)}
    keys = {_scene._SINGULAR.get(name, name if name in ("parts_list", "all_sheets", "title_block") else name[:-1])
            for name in sections}
    text = (SAMPLES.parent / "docs" / "scenes.md").read_text()
    import re
    wanted = set(re.findall(r"^\| [^|]*`\[\[?([a-z_]+)\]\]?`", text, re.M))
    assert wanted and wanted <= keys
    assert _parts.View.__doc__ and "`hidden`" in _parts.View.__doc__
