# SPDX-License-Identifier: Apache-2.0
"""The views of the bench."""

import numpy

VIEWS = {"front": (0, -1, 0), "top": (0, 0, 1), "isometric": (1, -1, 1), "section": (0, -1, 0)}  # towards the viewer


def axes_of(viewer):
    """Rows right, up, to the viewer; z is up, or y in a view along z."""
    towards = numpy.array(viewer, float) / numpy.linalg.norm(viewer)
    right = numpy.cross((0, 1, 0) if abs(towards[2]) > 0.999 else (0, 0, 1), towards)
    right /= numpy.linalg.norm(right)
    return numpy.array((right, numpy.cross(towards, right), towards))
