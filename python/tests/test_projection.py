# SPDX-License-Identifier: Apache-2.0
"""Projections written in Python."""
import os
import signal
import sys
import threading
import time

import numpy as np
import pytest

import epura
from epura.projection import Plane, choice, number, towards_viewer, vector
from shapes import FACES, VERTICES


class Shadow:
    name = "shadow"
    family = "sun"
    summary = "shadow on the ground, seen from above"
    parameters = [number("azimuth", "deg", "how far to the right of the front the sun stands", 30, -360, 360),
                  number("elevation", "deg", "the sun's height above the horizon", 45, 1, 90)]

    @staticmethod
    def project(scene, azimuth, elevation):
        return Plane(normal=(0, 0, 1), up=(0, 1, 0), projector=towards_viewer(azimuth, elevation))


def made(project, parameters=()):
    """A class that does this."""
    return type("Made", (), {"name": "made", "family": "test", "summary": "made for a test", "parameters": parameters,
                             "project": staticmethod(project)})


def extent(drawing):
    return np.ptp(drawing.views[0].segments.reshape(-1, 2), axis=0)


def test_the_shadow_of_a_cube():
    drawing = epura.draw(VERTICES, FACES, projection=Shadow, parameters={"azimuth": 90}, scale=1)
    assert drawing.views[0].projection == "shadow"
    # The sun stands right, as high as far: the upper face falls 9 mm to the left.
    assert extent(drawing) == pytest.approx([18, 9], abs=1e-3)


def test_by_name_with_parameters_as_text_and_in_scenes():
    by_class = epura.draw(VERTICES, FACES, projection=Shadow, parameters={"elevation": 60}).to_svg()
    assert epura.draw(VERTICES, FACES, projection="shadow:elevation=60", projections=[Shadow]).to_svg() == by_class
    scene = epura.Scene(models=[epura.Model(VERTICES, FACES)], views=["front", Shadow, epura.View(Shadow, name="b")])
    assert [view.projection for view in epura.draw(scene).views] == ["front", "shadow", "shadow"]
    with pytest.raises(epura.Error, match="shadow") as caught:
        epura.draw(VERTICES, FACES, projection="shadwo", projections=[Shadow])
    assert "did you mean 'shadow'" in caught.value.hint


def test_it_sees_the_box_and_all_kinds_of_values():
    seen = []

    def project(scene, side, eye, word):
        seen.append((scene.least.tolist(), scene.most.tolist(), scene.diagonal, side, eye.tolist(), word))
        return Plane((0, -1, 0), (0, 0, 1), eye, point=scene.centre, central=True)

    table = [number("side", "1", "a number", float("nan")), vector("eye", "mm", "the eye", (4, -90, 5)),
             choice("word", "one of two", "left|right", 1)]
    epura.draw(VERTICES, FACES, projection=made(project, table), parameters={"side": 3, "word": "left"})
    assert seen == [([0, 0, 0], [9, 9, 9], pytest.approx(9 * np.sqrt(3)), 3, [4, -90, 5], "left")]


@pytest.mark.parametrize("project, words", [
    (lambda scene: 1 / 0, "raised ZeroDivisionError: division by zero"),
    (lambda scene: None, "returned a NoneType"),
    (lambda scene: Plane((0, 0, 1), (0, 1), (0, 0, 1)), "Plane.up has 2 components"),
    (lambda scene: Plane((0, 0, 1), (0, 0, 1), (0, 0, 1)), "parallel to the normal"),
    (lambda scene: Plane((0, 0, 1), (0, 1, 0), (float("nan"), 0, 1)), "the projector is not finite"),
    (lambda scene: Plane((0, 0, 1), (0, 1, 0), ("a", 0, 1)), "could not convert"),
    (lambda scene, missing: None, "raised TypeError"),
    (lambda scene: sys.exit(1), "raised SystemExit"),
])
def test_faults_name_the_class_and_the_line(project, words):
    with pytest.raises(epura.PluginError) as caught:
        epura.draw(VERTICES, FACES, projection=made(project))
    text = str(caught.value)
    assert words in text and "class test_projection.Made" in text and "'made'" in text
    if "raised" in words:
        assert ".py:" in text


def test_values_are_refused_by_the_table_and_by_the_class():
    with pytest.raises(epura.InputError, match="allowed is 1 to 90"):
        epura.draw(VERTICES, FACES, projection=Shadow, parameters={"elevation": 0})

    def project(scene, a):
        raise ValueError("the sun has set")

    with pytest.raises(epura.InputError, match=r"the sun has set .*test_projection\.py:\d+"):
        epura.draw(VERTICES, FACES, projection=made(project, [number("a", "1", "x", 0)]), parameters={"a": 1})


@pytest.mark.parametrize("change, words", [
    ({"name": "Made"}, "lower case"),
    ({"parameters": [number("A", "1", "x", 0)]}, "lower case"),
    ({"parameters": [number("a", "1", "x", 9, 0, 1)]}, "outside its range"),
    ({"parameters": [vector("a", "1", "x", range(9))]}, "9 components"),
    ({"parameters": [number("a", "1", "x", 0), number("a", "1", "x", 0)]}, "two parameters 'a'"),
])
def test_tables_are_checked_as_those_of_plugins(change, words):
    owner = type("Owner", (made(lambda scene, *values: None),), change)
    with pytest.raises(epura.PluginError, match=words) as caught:
        epura.draw(VERTICES, FACES, projection=owner)
    assert "class test_projection.Owner" in caught.value.place


def test_threads_draw_with_their_own_projections():
    results = {}

    def draw(azimuth):
        results[azimuth] = epura.draw(VERTICES, FACES, projection=Shadow, parameters={"azimuth": azimuth}).to_svg()

    threads = [threading.Thread(target=draw, args=(10 * i,)) for i in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for azimuth, svg in results.items():
        assert svg == epura.draw(VERTICES, FACES, projection=Shadow, parameters={"azimuth": azimuth}).to_svg()
    assert len(set(results.values())) == 8


def test_ctrl_c_ends_a_projection_that_does_not_return():
    def project(scene):
        while True:
            time.sleep(0.01)

    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        epura.draw(VERTICES, FACES, projection=made(project))
    assert time.monotonic() - begin < 5
    epura.draw(VERTICES, FACES, projection=Shadow)
