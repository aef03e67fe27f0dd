# SPDX-License-Identifier: Apache-2.0
"""What tests in Python claim; those that do not hold are printed and collected in `failures`."""

failures = []


def check(what, is_right, found=""):
    if not is_right:
        failures.append(what)
        print(f"FAILED: {what} {found}")


def same(what, found, wanted):
    check(what, found == wanted, f"is {found!r}, should be {wanted!r}")
