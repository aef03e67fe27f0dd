#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The manual page as its readers see it: man and mandoc find nothing wrong.  tests/manual.sh EPURA
set -uo pipefail
epura=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 2
status=0

complain() {  # what, log
  [ -z "$2" ] && return
  printf 'manual: %s:\n%s\n' "$1" "$2" >&2
  status=1
}

"$epura" manual >epura.1 || exit 1
read_it() { MANWIDTH=80 MANROFFOPT=-ww LC_ALL=C.UTF-8 man --warnings -l epura.1 2>&1 >page.txt; }
if command -v man >/dev/null; then
  complain "man" "$(read_it)"
  for word in SYNOPSIS --projection cabinet EPURA_PLUGIN_PATH cancelled; do
    grep -q -e "$word" page.txt || complain "the page does not tell" "$word"
  done
else
  echo "manual: no man" >&2
fi
if command -v mandoc >/dev/null; then
  # The date is missing on purpose: the page is made by the program, whose version it names.
  complain "mandoc" "$(mandoc -T lint -W warning epura.1 | grep -v 'missing date')"
else
  echo "manual: no mandoc" >&2
fi
exit $status
