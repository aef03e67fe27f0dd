#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The module for Python as a user installs it from this tree: by pip without a network into a new environment, used there,
# also by pytest in a project of its own, and removed. Builds in build/pip: minutes, the first time.  tests/pip.sh [PIP-OPTION...]
# On an installed epura, half a minute:  tests/pip.sh --config-settings=installed=PREFIX
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."
root=$PWD
/usr/bin/python3 -c 'import venv, ensurepip, pytest' 2>/dev/null ||
  { echo "pip: skipped, for there is no venv or no pytest (apt-get install python3-venv python3-pytest)" >&2; exit 0; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "pip: $*" >&2; exit 1; }

# numpy and pytest are those of the system.
/usr/bin/python3 -m venv --system-site-packages "$scratch/env"
export PATH=$scratch/env/bin:$PATH PYTHONDONTWRITEBYTECODE=1
unset PYTHONPATH
case "$*" in *installed=*) ;; *) set -- --config-settings=installed=no "$@" ;; esac
pip --quiet --disable-pip-version-check install --no-index --no-build-isolation "$@" . || fail "cannot be installed"

cd "$scratch"
python - "$root" <<'END' || fail "does not work"
import pathlib, sys
import epura
samples = pathlib.Path(sys.argv[1], "samples")
assert pathlib.Path(epura.__file__).is_relative_to(sys.prefix), epura.__file__
drawing = epura.draw(samples / "models/bracket.obj", views=["front", "top", "isometric"], title="Bracket")
assert drawing.save("a.pdf") == ["a.pdf"]  # by a library that is loaded when it is needed
assert epura.compare("a.pdf", drawing)
try:
    step = epura.draw(samples / "step/clamp.step")
    print(f"STEP: {len(step.views[0].segments)} lines")
except epura.Error as error:
    print(f"STEP: {error}")
END

mkdir -p project/tests
cat >project/tests/test_part.py <<'END'
import os
import epura
from epura.testing import assert_drawing

def test_part():
    assert_drawing(epura.draw(os.environ["PART"], views=["front", "top"]), "part.svg")
END
export PART=$root/samples/models/flange.obj
in_project() { (cd project && python -m pytest -q -p no:cacheprovider "$@" >"$scratch/log" 2>&1); }
in_project && fail "a missing drawing passes"
grep -- '--epura-accept' "$scratch/log" >/dev/null || { cat "$scratch/log" >&2; fail "does not tell how to accept"; }
in_project --epura-accept || { cat "$scratch/log" >&2; fail "is not accepted"; }
in_project || { cat "$scratch/log" >&2; fail "an accepted drawing fails"; }
PART=$root/samples/models/bracket.obj in_project && fail "another part passes"

pip --quiet uninstall --yes epura
find "$scratch/env" -iname '*epura*' | grep . && fail "leaves files behind"
echo "pip: installed, used and removed"
