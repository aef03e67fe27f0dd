# SPDX-License-Identifier: Apache-2.0
"""Models whose drawings are known."""
import os
from pathlib import Path

import numpy as np

SAMPLES = Path(os.environ["EPURA_SAMPLES"])
VERTICES = np.array([[x, y, z] for z in (0, 9) for x, y in ((0, 0), (9, 0), (9, 9), (0, 9))], dtype=float)
FACES = np.array([[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])


def grid(n):
    """A wavy surface with 2 n^2 triangles, which takes seconds."""
    x, y = np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0), indexing="ij")
    points = np.stack([x, y, 3 * np.sin(x) * np.cos(y)], axis=-1).reshape(-1, 3)
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    return points, np.concatenate([np.stack([a, a + n + 1, a + n + 2], 1), np.stack([a, a + n + 2, a + 1], 1)])
