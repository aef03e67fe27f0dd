#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What a library shows to the linker:  tests/symbols.sh LIBRARY SONAME LIST [--renew]
# Its functions are those of the list in tests/; weak symbols are instances of the standard library or belong to the
# classes of the interface; it is known by the version of its interface.
set -uo pipefail
library=$1 soname=$2
list=$(dirname "$(realpath "$0")")/$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0

complain() {
  echo "symbols: $*" >&2
  status=1
}

nm -D -C --defined-only "$library" | cut -d' ' -f2- >"$scratch/all" && [ -s "$scratch/all" ] || exit 2
grep -v '^[WVu] ' "$scratch/all" | cut -d' ' -f2- | LC_ALL=C sort >"$scratch/strong"
if [ "${4-}" = --renew ]; then
  cp "$scratch/strong" "$list"
elif ! diff "$list" "$scratch/strong" >&2; then
  complain "the interface has changed. If that is meant: tests/symbols.sh $library $soname $3 --renew, and tell it in CHANGELOG.md"
fi

own='(vtable for |typeinfo for |typeinfo name for )?epura::(Failure|Drawing)(::|$)'
standard='([^(<]* )?std::'
foreign='(OpenMesh|tbb|glm|CLI|toml|rapidjson|pugi|utf8)::'
weak=$(grep '^[WVu] ' "$scratch/all" | cut -d' ' -f2-)
others=$(grep -vE "^($own|$standard)" <<<"$weak")
[ -z "$others" ] || complain "weak symbols that are no part of the interface:"$'\n'"$others"
strangers=$(grep -E "$foreign" <<<"$weak")
[ -z "$strangers" ] || complain "of libraries that are linked:"$'\n'"$strangers"

readelf -d "$library" | grep -F "soname: [$soname]" >/dev/null || complain "the name is not $soname: $(readelf -d "$library" | grep SONAME)"
exit $status
