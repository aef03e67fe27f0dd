# SPDX-License-Identifier: Apache-2.0
"""The notebook of the samples runs, and shows drawings."""
import json
import os
import subprocess
import sys

import pytest

from shapes import SAMPLES


def test_the_notebook_runs(tmp_path):
    pytest.importorskip("nbconvert", reason="there is no python3-nbconvert")
    pytest.importorskip("ipykernel", reason="there is no python3-ipykernel")
    environment = {**os.environ, "HOME": str(tmp_path), "IPYTHONDIR": str(tmp_path / "ipython"),
                   "JUPYTER_RUNTIME_DIR": str(tmp_path / "runtime")}
    ran = subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--output-dir", tmp_path,
                          SAMPLES / "notebook.ipynb"], capture_output=True, text=True, env=environment)
    assert ran.returncode == 0, ran.stderr
    cells = json.loads((tmp_path / "notebook.ipynb").read_text())["cells"]
    outputs = [output for cell in cells for output in cell.get("outputs", [])]
    pictures = ["".join(output["data"]["image/svg+xml"]) for output in outputs
                if "image/svg+xml" in output.get("data", {})]
    assert len(pictures) == 2 and all(picture.count("<path") > 3 for picture in pictures)
    texts = "".join("".join(output.get("text", "")) for output in outputs)
    assert "picture" in texts and "moved" in texts, texts
