#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Programs and libraries hold no trace of where and when they were built:  tests/traces.sh FILE_OR_FOLDER...
set -uo pipefail
root=$(cd "$(dirname "$(realpath "$0")")/.." && pwd)
months=$(LC_ALL=C.UTF-8 locale abmon | tr ';' '|')
status=0
count=0
while IFS= read -r file; do
  [ "$(head -c 4 "$file" | tail -c 3)" = ELF ] || continue
  count=$((count + 1))
  words=$(strings -a "$file")
  # __FILE__ and the like, and __DATE__.
  if found=$(grep -m 1 -F -- "$root" <<<"$words") || found=$(grep -m 1 -wE "($months) [ 123][0-9] 20[0-9]{2}" <<<"$words"); then
    echo "traces: $file holds '$found'" >&2
    status=1
  fi
done < <(find "$@" -type f | LC_ALL=C sort)
[ $count -gt 0 ] || { echo "traces: there is no program in $*" >&2; exit 2; }
exit $status
