# SPDX-License-Identifier: Apache-2.0
"""Plain values -> the nodes that _core reads: (key, place, content)."""

from __future__ import annotations

import dataclasses
import datetime
import os
from typing import Any, List, Mapping, Sequence, Tuple, Union

import numpy as np

from ._errors import InputError

# A list of nodes is a list, a table a tuple.
Content = Union[str, float, bool, List["Node"], Tuple["Node", ...]]
Node = Tuple[str, str, Content]


def _key_of(name: str) -> str:
    """Words of the language have an underscore: `from_`."""
    return name[:-1] if name.endswith("_") else name


def fields_of(part: Any) -> Mapping[str, Any]:
    """What is given of a part of a scene, by the keys of scene files."""
    return {_key_of(field.name): value for field in dataclasses.fields(part)
            if (value := getattr(part, field.name)) is not None}


def node(key: str, place: str, value: Any) -> Node:
    """Raises InputError for values that are none of a scene."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        value = fields_of(value)
    if isinstance(value, (str, bool)):
        return key, place, value
    if isinstance(value, (int, float)):
        return key, place, float(value)
    if isinstance(value, datetime.date):
        return key, place, value.isoformat()
    if isinstance(value, os.PathLike):
        return key, place, os.fspath(value)
    if isinstance(value, Mapping):
        return key, place, tuple(node(str(name), f"{place}.{name}" if place else str(name), one)
                                 for name, one in value.items())
    if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray)):
        return key, place, [node(key, f"{place}[{i}]", one) for i, one in enumerate(value)]
    raise InputError(f"{place}: is of type {type(value).__name__}", place, "give a text, a number, a list or a dictionary")
