# SPDX-License-Identifier: Apache-2.0
"""What can be a model: each draws as the same arrays do."""
from types import SimpleNamespace

import numpy as np
import pytest

import epura
from shapes import FACES, SAMPLES, VERTICES

TRIANGLES = np.concatenate([FACES[:, :3], FACES[:, [0, 2, 3]]])


def expected():
    return epura.draw(VERTICES, FACES)


def same(model, tolerance=0.001):
    found = epura.compare(expected(), epura.draw(model), tolerance)
    assert found, found.words


class Vector:
    """As of build123d."""

    def __init__(self, x, y, z):
        self.X, self.Y, self.Z = x, y, z


class CadQueryVector:
    def __init__(self, *xyz):
        self.xyz = xyz

    def toTuple(self):  # noqa: N802
        return self.xyz


class Solid:
    """Has methods where meshes have data, as in build123d."""

    def __init__(self, vector):
        self.vector, self.tolerances = vector, []

    def vertices(self):
        return []

    def faces(self):
        return []

    def tessellate(self, tolerance):
        self.tolerances.append(tolerance)
        return [self.vector(*row) for row in VERTICES], [tuple(row) for row in TRIANGLES.tolist()]


def test_meshes_of_arrays():
    same(SimpleNamespace(vertices=VERTICES, faces=FACES))
    same(SimpleNamespace(vertices=VERTICES.tolist(), faces=FACES.tolist()))
    same(SimpleNamespace(vertices=VERTICES, triangles=TRIANGLES))
    same(epura.Model(VERTICES, FACES[:-1].tolist() + [[3, 0, 4], [3, 4, 7]]))


def test_meshes_of_meshio():
    cells = {"quad": FACES[:3], "triangle": np.concatenate([FACES[3:, :3], FACES[3:, [0, 2, 3]]]), "line": [[0, 1]]}
    same(SimpleNamespace(points=VERTICES, cells_dict=cells))
    middle = np.concatenate([TRIANGLES, np.zeros_like(TRIANGLES)], axis=1)
    same(SimpleNamespace(points=VERTICES, cells_dict={"triangle6": middle}))
    with pytest.raises(epura.InputError, match="'tetra', which is no surface"):
        epura.draw(SimpleNamespace(points=VERTICES, cells_dict={"tetra": np.array([[0, 1, 2, 4]])}))


@pytest.mark.parametrize("vector", [Vector, CadQueryVector, lambda *xyz: xyz])
def test_solids_that_tessellate(vector):
    same(Solid(vector))
    solid = Solid(vector)
    epura.draw(solid)
    assert solid.tolerances[-1] == pytest.approx(9 * np.sqrt(3) / 20000)  # 1/20000 of the diagonal
    solid = Solid(vector)
    epura.draw(epura.Model(solid, tolerance=0.25))
    assert solid.tolerances == [0.25]
    same(SimpleNamespace(val=lambda: Solid(vector)))  # a Workplane
    same(SimpleNamespace(part=Solid(vector)))  # a BuildPart


def test_scenes_of_trimesh():
    whole = SimpleNamespace(vertices=VERTICES, faces=FACES)
    same(SimpleNamespace(geometry={"a": None}, dump=lambda concatenate: whole))


def test_bytes_of_a_file():
    data = (SAMPLES / "models" / "bracket.obj").read_bytes()
    from_file = epura.draw(SAMPLES / "models" / "bracket.obj")
    assert epura.compare(epura.draw(epura.Model(data, format="obj")), from_file)
    assert epura.compare(epura.draw(epura.Model(memoryview(data), format="obj", unit="mm")), from_file)
    with pytest.raises(epura.InputError, match="bytes need one") as caught:
        epura.draw(data)
    assert caught.value.place == "models[0].format"
    with pytest.raises(epura.InputError, match="model.obj:1"):
        epura.draw(epura.Model(b"v 1 2\n", format="obj"))


def test_options_of_models():
    moved = epura.draw(epura.Scene(models=[epura.Model(VERTICES, FACES, transform="scale:2", line="narrow")],
                                   views=["front"], sheets=[epura.Sheet(scale=1)]))
    lines = moved.views[0].segments
    assert np.ptp(lines[..., 0]) == pytest.approx(18, abs=1e-3)
    matrix = np.diag([2.0, 2, 2, 1])
    by_matrix = epura.draw(epura.Scene(models=[epura.Model(VERTICES, FACES, transform=matrix, line="narrow")],
                                       views=["front"], sheets=[epura.Sheet(scale=1)]))
    assert by_matrix.to_svg() == moved.to_svg()
    with pytest.raises(epura.InputError, match="last row"):
        epura.draw(epura.Model(VERTICES, FACES, transform=np.ones((4, 4))))
    with pytest.raises(TypeError):
        epura.Model(VERTICES, FACES, transfrom="scale:2")


def test_arrays_are_borrowed():
    """Only what is not as the library has it is copied."""
    from epura import _models

    points, corners = VERTICES.copy(), FACES.astype(np.int32)
    _, source = _models.described(epura.Model(points, corners), 0, 1)
    assert np.shares_memory(source["points"], points) and np.shares_memory(source["faces"][0], corners)
    _, source = _models.described(epura.Model(points.astype(np.float32), corners), 0, 1)
    assert source["single_precision"]


def test_faces_on_any_wrong_index():
    for face in ([0, 1, 8], [0, 1, -1], [0, 1, 2**40]):
        with pytest.raises(epura.InputError) as caught:
            epura.draw(VERTICES, np.array([face]))
        assert caught.value.place.startswith("models[0].faces") and caught.value.hint
