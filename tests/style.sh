#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The house rules that a machine can hold: sizes, paths, format.  tests/style.sh [FOLDER]
set -uo pipefail
export LC_ALL=C  # wc and sort speak the language of the locale
root=$(realpath "${1:-$(dirname "$(realpath "$0")")/..}")
cd "$root" || exit 2
status=0

complain() {  # what, where
  [ -z "$2" ] && return
  printf '%s:\n%s\n' "$1" "$2" >&2
  status=1
}

sources() { find . \( -name build -o -name out -o -name .git \) -prune -o -type f \( -name '*.[ch]pp' -o -name '*.h' \) -print | sort; }

# A function or a class starts at the left margin and ends with a brace there; clang-format sees to that.
long_functions() {
  awk 'FNR == 1 { start = 0 }
       /^[A-Za-z].*[({,]$|^[A-Za-z].*\) *(const )?\{$/ && !/^(namespace|struct|class|enum|union|extern|using|static constexpr)/ \
         { if (!start) start = FNR }
       /^}/ { if (start && FNR - start + 1 > 70) print FILENAME ":" start ": " FNR - start + 1 " lines"; start = 0 }
       /;$/ && !/^ / { start = 0 }' "$@"
}

# Two types of one name in one namespace: the linker takes functions of either for both, and says nothing.
repeated_types() {
  awk 'FNR == 1 { space = ""; hidden = 0 }
       /^namespace \{/ { hidden = 1 }
       /^}  \/\/ namespace$/ { hidden = 0 }
       /^namespace [a-z_:]+ \{/ { space = $2 }
       /^(struct|class|enum|enum class) [A-Za-z]+ (: [^{]*)?\{/ && !hidden {
         name = space "::" ($2 == "class" ? $3 : $2)
         if (name in seen && seen[name] != FILENAME) print name ": " seen[name] ", " FILENAME
         seen[name] = FILENAME }' "$@"
}

# Every folder of src/ has its namespace; base, app and library are epura itself, and what runs the stages is one.
foreign_namespaces() {
  local folder name
  for folder in $(find src -mindepth 2 -maxdepth 2 -type d | grep -vE '/(base|app|library)$'); do
    name=${folder##*/}
    case $name in views | composition) name=pipeline ;; sizes | dimensions | annotations) name=sheet ;; esac
    grep -rlE '^namespace epura' "$folder" --include='*.[ch]pp' | xargs -r grep -L "^namespace epura::$name {"
  done
}

# A stage that has a header of limits tells all of them there: no floating-point constant has a name elsewhere.
scattered_limits() {
  local header
  for header in src/*/*/limits.hpp; do
    [ -e "$header" ] || continue
    grep -nE '(^|[^a-z_])constexpr (double|float) [a-z_0-9]+( =|\{)' "${header%/*}"/*.[ch]pp | grep -v "^$header:"
  done
}

# Stages take and return values. Commands and programs of their own print, and the folders of a user are in the environment.
impure_stages() {
  grep -rnE '(^|[^a-z_])(printf|fprintf|puts|getenv)\(|std::(cout|cerr|clog)' src --include='*.[ch]pp' |
    grep -vE '^src/(run/app/|run/library/make_|input/importer/host\.cpp|ground/foreign/folders\.cpp)'
}

# Headers that comments and pages name are there, from the root or from their district.
absent_headers() {
  local path='([a-z_]+/)+[a-z_0-9]+\.hpp' name
  grep -rhE "$path" src docs ./*.md --include='*.[ch]pp' --include='*.md' 2>/dev/null | grep -v '#include' |
    grep -oE "$path" | sort -u | grep -v '^epura/' | while read -r name; do
    [ -e "$name" ] || compgen -G "src/*/$name" >/dev/null || grep -rnF "$name" src docs ./*.md
  done
}

# A kind of sizes is a row of one table: whatever reads it asks the table, not the kind.
scattered_kinds() {
  local table=src/sheet/sizes/feature_table.hpp kind count
  [ -e "$table" ] || return
  sed -n 's/^enum class SizeKind : unsigned char { \(.*\) };$/\1/p' "$table" | tr -d ' ' | tr ',' '\n' | while read -r kind; do
    count=$(grep -rlE "SizeKind::$kind([^a-z_]|$)" src --include='*.[ch]pp' | grep -vc "^$table$")
    [ "$count" -le 3 ] || grep -rnE "SizeKind::$kind([^a-z_]|$)" src --include='*.[ch]pp'
  done
}

mapfile -t files < <(sources)
if [ ${#files[@]} -eq 0 ]; then
  echo "style: no sources under $root" >&2
  exit 2
fi

complain "files longer than 600 lines" "$(wc -l "${files[@]}" | awk '$1 > 600 && $2 != "total"')"
complain "functions longer than 70 lines" "$(long_functions "${files[@]}")"
complain "files without a licence" "$(grep -L 'SPDX-License-Identifier: Apache-2.0' "${files[@]}")"
complain "files outside the namespace of their folder" "$(foreign_namespaces)"
complain "limits elsewhere than in the limits.hpp of their folder" "$(scattered_limits)"
complain "stages that print, or read the environment" "$(impure_stages)"
complain "headers that are not there" "$(absent_headers)"
complain "kinds of sizes that more than four files name" "$(scattered_kinds)"
complain "types of one name" "$(repeated_types "${files[@]}")"
complain "headers without a guard" \
  "$(printf '%s\n' "${files[@]}" | grep -E '\.(hpp|h)$' | xargs -r grep -L -e '#pragma once' -e '#ifndef')"
complain "paths of a machine" "$(grep -rInE '(^|[^A-Za-z0-9_.])/(home|work|root)/|\.\./shared' . \
  --exclude-dir=.git --exclude=.git --exclude-dir=build --exclude-dir=out)"
if command -v clang-format-14 >/dev/null; then
  complain "not formatted (clang-format-14 -i)" "$(clang-format-14 --dry-run -Werror "${files[@]}" 2>&1 |
    grep error: | cut -d: -f1 | sort | uniq -c)"
else
  echo "style: clang-format-14 is not installed; format not checked" >&2
fi
exit $status
