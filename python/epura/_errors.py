# SPDX-License-Identifier: Apache-2.0
"""The exceptions of epura."""

__all__ = ["Error", "InputError", "OutputError", "PluginError", "TimeError"]


class Error(Exception):
    """Any error that the caller can correct: `place` says where, `hint` how (empty if there is no remedy)."""

    def __init__(self, message: str, place: str = "", hint: str = "") -> None:
        super().__init__(message + (f"\nhint: {hint}" if hint else ""))
        self.message = message
        self.place = place
        self.hint = hint


class InputError(Error, ValueError):
    """A wrong model or option."""


class PluginError(Error):
    """A projection or an importer failed."""


class OutputError(Error, OSError):
    """A file cannot be written."""


class TimeError(Error, TimeoutError):
    """`time_limit` left nothing to show."""


_BY_KIND = {2: InputError, 3: PluginError, 4: OutputError, 5: TimeError}


def made(kind: int, place: str, message: str, hint: str) -> Error:
    return _BY_KIND.get(kind, Error)(message, place, hint)
