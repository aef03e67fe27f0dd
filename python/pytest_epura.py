# SPDX-License-Identifier: Apache-2.0
"""The plugin of epura for pytest. It does not import epura, so tests without drawings are not slowed down."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Optional

_config: Any = None
_folder: Optional[Path] = None


def accepts() -> bool:
    """Whether drawings become the expected ones."""
    return _config is not None and bool(_config.getoption("--epura-accept"))


def folder() -> Path:
    """Where relative paths of expected drawings start."""
    return _folder or Path()


def pytest_addoption(parser: Any) -> None:
    parser.getgroup("epura").addoption("--epura-accept", action="store_true",
                                       help="make the drawings of epura.testing.assert_drawing the expected ones")


def pytest_configure(config: Any) -> None:
    global _config
    _config = config


def pytest_runtest_setup(item: Any) -> None:
    global _folder
    _folder = Path(item.path).parent


def pytest_runtest_teardown() -> None:
    global _folder
    _folder = None
