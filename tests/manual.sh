#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The manual pages as their readers see them: man and mandoc find nothing wrong.  tests/manual.sh EPURA
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

# page command word...
check() {
  local page=$1
  "$epura" $2 >"$page" || exit 1
  shift 2
  if command -v man >/dev/null; then
    complain "man" "$(MANWIDTH=80 MANROFFOPT=-ww LC_ALL=C.UTF-8 man --warnings -l "$page" 2>&1 >page.txt)"
    for word; do grep -q -e "$word" page.txt || complain "the page does not tell" "$word"; done
  else
    echo "manual: no man" >&2
  fi
  if command -v mandoc >/dev/null; then
    # The date is missing on purpose: the page is made by the program, whose version it names.
    complain "mandoc" "$(mandoc -T lint -W warning "$page" | grep -v 'missing date')"
  else
    echo "manual: no mandoc" >&2
  fi
}

check epura.1 manual SYNOPSIS --projection cabinet EPURA_PLUGIN_PATH cancelled
check epura-study.1 "study manual" SYNOPSIS stability paper --truth EPURA_PLUGIN_PATH cancelled
exit $status
