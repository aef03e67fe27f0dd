# SPDX-License-Identifier: Apache-2.0
"""The types of the module, and of what is written with it."""
from pathlib import Path

import epura
import pytest

USE = '''
import numpy as np
import epura
from epura import projection
from epura.testing import assert_drawing

class Shadow:
    name = "shadow"
    family = "sun"
    summary = "shadow on the ground"
    parameters = [projection.number("azimuth", "deg", "of the sun", 30)]

    def project(self, scene: projection.Box, azimuth: float) -> projection.Plane:
        return projection.Plane((0, 0, 1), (0, 1, 0), projection.towards_viewer(azimuth, 45))

scene = epura.Scene(models=[epura.Model("a.obj", unit="mm")], views=[epura.View("front", hidden="none"), Shadow],
                    sections=[epura.Section("A", normal=(0, 1, 0))], sheets=[epura.Sheet("A3", scale=0.5)])
drawing: epura.Drawing = epura.draw(scene, progress=lambda stage, done: None)
lengths: np.ndarray = np.linalg.norm(drawing.views[0].segments, axis=2)
assert_drawing(drawing, "a.svg")
print(epura.compare(drawing, "a.svg").differences[0]["change"])
'''


@pytest.fixture(scope="module")
def mypy(tmp_path_factory):
    """Runs it; what one run learns of numpy, which takes most of the time, the next ones know."""
    api = pytest.importorskip("mypy.api")
    cache = tmp_path_factory.mktemp("cache")

    def run(*arguments):
        text, errors, status = api.run(["--strict", "--cache-dir", str(cache), "--no-error-summary", *arguments])
        return text + errors, status

    return run


def test_the_module_is_typed(mypy):
    package = Path(epura.__file__).parent
    text, status = mypy("--ignore-missing-imports", "--no-warn-unused-ignores", "--allow-any-generics", str(package),
                        str(package.parent / "pytest_epura.py"))
    assert status == 0, text


def test_what_uses_it_is_typed(mypy, tmp_path, monkeypatch):
    monkeypatch.setenv("MYPYPATH", str(Path(epura.__file__).parent.parent))
    use = tmp_path / "use.py"
    use.write_text(USE)
    text, status = mypy("--ignore-missing-imports", "--allow-any-generics", str(use))
    assert status == 0, text
    use.write_text(USE.replace('hidden="none"', 'hidden="dotted"'))
    text, status = mypy("--ignore-missing-imports", "--allow-any-generics", str(use))
    assert status == 1 and '"hidden"' in text, text
