# SPDX-License-Identifier: Apache-2.0
"""Curves of shapes in memory."""
import base64
import ctypes
import json
import re
import runpy
import sys
from types import SimpleNamespace

import numpy as np
import pytest

import epura
from shapes import FACES, SAMPLES, VERTICES


def length(curves):
    return sum(np.linalg.norm(np.diff(points, axis=0), axis=1).sum() for points in curves)


def test_cube_has_nine_visible_edges_and_three_hidden_ones():
    curves = epura.hlr(VERTICES, FACES)
    edge = 9 * np.sqrt(2 / 3)
    assert length(curves.visible) == pytest.approx(9 * edge)
    assert length(curves.hidden) == pytest.approx(3 * edge)
    assert {curve.kind for curve in curves.curves} <= {"contour", "crease"}


def test_points_lie_where_the_matrix_says():
    curves = epura.hlr(VERTICES, FACES, eye=(30, -40, 25), target=(4, 4, 4))
    seen = np.c_[VERTICES, np.ones(8)] @ curves.matrix.T
    corners = seen[:, :2] / seen[:, 3:]
    for curve in curves.curves:
        for end in curve.points[[0, -1]]:
            if curve.visible:  # from corner to corner, or to where another edge hides it
                assert np.linalg.norm(corners - end, axis=1).min() < 1e-6


def test_matrix_is_taken_as_it_is():
    matrix = np.array([[2, 0, 0, 5], [0, 2, 0, 7], [0, 0, 1, 0], [0, 0, 0, 1.0]])
    curves = epura.hlr(VERTICES, FACES, matrix=matrix, hidden=False)
    points = np.concatenate(curves.visible)
    assert points.min(axis=0) == pytest.approx([5, 7]) and points.max(axis=0) == pytest.approx([23, 25])
    assert curves.matrix[:2] == pytest.approx(matrix[:2])
    assert not curves.hidden


def test_rims_become_arcs():
    n = 48
    angles = 2 * np.pi * np.arange(n) / n
    rim = np.stack([5 * np.cos(angles), 5 * np.sin(angles)], axis=1)
    points = np.concatenate([np.c_[rim, np.zeros(n)], np.c_[rim, np.full(n, 8)]])
    faces = [list(range(n))[::-1], list(range(n, 2 * n))]
    faces += [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
    curves = epura.hlr(points, faces, direction=(0, 0, 1), up=(0, 1, 0), arcs=0.01, hidden=False)
    arcs = [curve.arc for curve in curves.curves if curve.type == "circle"]
    assert sum(abs(arc.end - arc.start) for arc in arcs) == pytest.approx(2 * np.pi)
    assert all(np.hypot(*arc.u) == pytest.approx(5) for arc in arcs)


def test_objects_of_other_libraries_are_taken():
    expected = length(epura.hlr(VERTICES, FACES).visible)
    assert length(epura.hlr(SimpleNamespace(vertices=VERTICES, faces=FACES)).visible) == pytest.approx(expected)
    solid = SimpleNamespace(tessellate=lambda tolerance: (VERTICES.tolist(), FACES.tolist()))  # as FreeCAD and CadQuery
    assert length(epura.hlr(solid).visible) == pytest.approx(expected)


def spline_points(spline, parameters):
    """By the definition of Cox and de Boor."""
    k, t = spline.knots, np.asarray(parameters)[:, None]
    spans = (k[:-1] <= t) & (t < k[1:]) & (k[:-1] < k[1:])
    spans[t[:, 0] >= k[-1], np.flatnonzero(k[:-1] < k[1:])[-1]] = True
    shares = spans.astype(float)
    for degree in range(1, spline.degree + 1):
        rise, fall = (k[degree:-1] - k[:-degree - 1], k[degree + 1:] - k[1:-degree])
        up, down = (np.divide(1, width, out=np.zeros_like(width), where=width > 0) for width in (rise, fall))
        shares = (t - k[:-degree - 1]) * up * shares[:, :-1] + (k[degree + 1:] - t) * down * shares[:, 1:]
    shares = shares * spline.weights
    return shares @ spline.poles / shares.sum(axis=1, keepdims=True)


def needs(ending):
    from epura import _hlr, _importers
    if not _importers.has_importer(_hlr._folder() / "epura" / "importers", ending):
        pytest.skip("the importer is not built")


def test_gltf_is_taken_by_its_bytes():
    needs("gltf")
    triangle = np.array([[0, 0, 0], [3, 0, 0], [0, 4, 0]], dtype="<f4").tobytes()
    text = json.dumps({
        "asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + base64.b64encode(triangle).decode()}]})
    curves = epura.hlr(text.encode(), format="gltf", direction=(0, 0, 1), up=(0, 1, 0))
    assert length(curves.visible) == pytest.approx(12)
    assert {curve.kind for curve in curves.curves} == {"boundary"}


def test_shapes_of_files_keep_their_faces_and_edges():
    needs("step")
    file = SAMPLES / "step" / "clamp.step"
    curves = epura.hlr(file)
    assert all(curve.edge is not None or curve.kind in ("contour", "intersection") for curve in curves.curves)
    assert all(1 <= len(curve.faces) <= 2 for curve in curves.curves)
    coarse = epura.hlr(file.read_bytes(), format="step", tolerance=1)
    assert length(coarse.visible) == pytest.approx(length(curves.visible), rel=0.01)
    assert sum(map(len, coarse.visible)) < sum(map(len, curves.visible))


def test_splines_of_files_are_told_with_what_is_seen_of_them():
    needs("step")
    curves = epura.hlr(SAMPLES / "step" / "clamp.step").curves
    splines = [curve for curve in curves if curve.type == "spline"]
    assert splines and all((curve.spline is None) == (curve.type != "spline") for curve in curves)
    for curve in splines:
        part = curve.spline
        assert len(part.knots) == len(part.poles) + part.degree + 1 and (part.weights > 0).all()
        at = spline_points(part, np.linspace(part.start, part.end, 2000))
        assert np.linalg.norm(curve.points[:, None] - at[None], axis=2).min(axis=1).max() < 0.05
        assert at[[0, -1]] == pytest.approx(curve.points[[0, -1]], abs=0.01)
    # What is seen and what is hidden of an edge are parts of one curve that do not overlap.
    for edge in {curve.edge for curve in splines}:
        parts = sorted(sorted((curve.spline.start, curve.spline.end)) for curve in splines if curve.edge == edge)
        assert all(one[1] <= other[0] + 1e-3 for one, other in zip(parts, parts[1:]))


def test_lines_are_told_as_such():
    types = {(curve.type, len(curve.points) == 2) for curve in epura.hlr(VERTICES, FACES).curves}
    assert ("line", True) in types and types <= {("line", True), ("polyline", False)}


def test_shapes_of_open_cascade_are_taken_as_text():
    needs("brep")
    shape = SimpleNamespace(exportBrepToString=lambda: "DBRep_DrawableShape\n")  # as FreeCAD
    with pytest.raises(epura.InputError, match="cut off or damaged"):
        epura.hlr(shape)


def test_shapes_of_ocp_are_taken_as_text(monkeypatch):
    needs("brep")
    kind = type("TopoDS_Solid", (), {"__module__": "OCP.TopoDS"})
    writer = SimpleNamespace(Write_s=lambda shape, stream: stream.write(b"DBRep_DrawableShape\n" if type(shape) is kind else b""))
    monkeypatch.setitem(sys.modules, "OCP.BRepTools", SimpleNamespace(BRepTools=writer))
    for shape in (kind(), SimpleNamespace(wrapped=kind()), SimpleNamespace(val=lambda: SimpleNamespace(wrapped=kind()))):
        with pytest.raises(epura.InputError, match="cut off or damaged"):
            epura.hlr(shape)


def test_addresses_that_hold_no_shape_are_refused():
    needs("brep")
    words = (ctypes.c_uint64 * 3)()
    here = ctypes.addressof(words)
    swig = SimpleNamespace(this=type("SwigPyObject", (), {"__int__": lambda self: here})())  # as pythonocc
    for shape, reason in ((0, "is null"), (1, "no shape at"), (8, "no shape at"), (here + 4, "no shape at"), (here, "is empty"),
                          (swig, "is empty"), (id(words), "no shape at"), (2**64 - 8, "no shape at")):
        with pytest.raises(epura.InputError, match=reason):
            epura.hlr(shape)


@pytest.mark.parametrize("source, more, place", [
    (b"glTF", {}, "format"), (b"glTF", {"format": "../x"}, "shape"), ("none.step", {}, "shape"), (b"glTF", {"format": "glb"}, "shape")])
def test_wrong_files_are_named(source, more, place):
    needs("glb")
    needs("step")
    with pytest.raises(epura.InputError) as error:
        epura.hlr(source, **more)
    assert error.value.place == place


@pytest.mark.parametrize("wrong, place", [
    ({"matrix": np.eye(3)}, "matrix"), ({"matrix": np.diag([1, 1, -1, 1])}, "matrix"), ({"kinds": ["outline"]}, "kinds"),
    ({"up": (1, -1, 1)}, "view"), ({"direction": "up"}, "direction"), ({"surfaces": "none"}, "surfaces"),
    ({"arcs": -1}, "arcs"), ({"faces": [[0, 1, 99]]}, "sink")])
def test_wrong_input_is_named(wrong, place):
    with pytest.raises(epura.InputError) as error:
        epura.hlr(VERTICES, **{"faces": FACES, **wrong})
    assert error.value.place == place


def test_blocks_of_the_page_run(capsys):
    page = (SAMPLES.parent / "docs" / "hlr.md").read_text()
    for block in re.findall(r"^```python\n(.*?)^```$", page, re.M | re.S):
        exec(compile(block, "docs/hlr.md", "exec"), {})
    assert re.fullmatch(r"\d+ visible, \d+ hidden\n", capsys.readouterr().out)


def test_samples_stand_in_for_other_programs():
    sample = runpy.run_path(str(SAMPLES / "hlr" / "like_others.py"))
    cube = SimpleNamespace(vertices=VERTICES, faces=FACES)
    visible, hidden = sample["project_to_viewport"](cube, (10, -10, 10))
    assert length(visible) == pytest.approx(3 * length(hidden))
    groups = sample["project_ex"](cube, direction=(1, -1, 1), up=(0, 0, 1))
    assert length(groups[0] + groups[2]) == pytest.approx(length(visible)) and not groups[1]
    assert sample["get_svg"](cube).count("<polyline") == len(epura.hlr(cube, direction=(-1.75, 1.1, 5), up=(0, 1, 0)).curves)
    text = sample["get_dxf"](cube)
    drawn = epura.hlr(cube, direction=(-1.75, 1.1, 5), up=(0, 1, 0)).curves
    for layer, visible in (("VISIBLE", True), ("HIDDEN", False)):
        number = r"\n(-?[\d.]+)"
        lines = re.findall(f"\nLINE\n8\n{layer}\n10{number}\n20{number}\n11{number}\n21{number}", text)
        ends = np.array(lines, dtype=float).reshape(-1, 2, 2)
        assert length(ends) == pytest.approx(length([curve.points for curve in drawn if curve.visible == visible]), abs=1e-4)
