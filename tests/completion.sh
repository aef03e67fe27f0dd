#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Completion as it is in the shells: what bash and fish offer at the end of a line; zsh reads its script.
#   tests/completion.sh EPURA
set -uo pipefail
PATH=$(dirname "$(realpath "$1")"):$PATH
export PATH
unset EPURA_PLUGIN_PATH
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 2
touch part.stl part.obj
mkdir partition
export HOME=$scratch XDG_CONFIG_HOME=$scratch XDG_DATA_HOME=$scratch
status=0

expect() {  # shell, line, wanted, got
  [ "$3" = "$4" ] && return
  printf "completion: %s offers '%s' at '%s|', not '%s'\n" "$1" "$4" "$2" "$3" >&2
  status=1
}

source <(epura completion bash)

# Breaks the line as readline does, with the words of the manual: blanks, ':' and '=' of $COMP_WORDBREAKS.
in_bash() {  # line
  COMP_LINE=$1 COMP_POINT=${#1} COMP_WORDS=()
  local rest=$1
  while [ -n "$rest" ]; do
    if [[ $rest =~ ^[[:space:]]+ ]]; then :
    elif [[ $rest =~ ^[:=]+ || $rest =~ ^[^:=[:space:]]+ ]]; then COMP_WORDS+=("${BASH_REMATCH[0]}")
    fi
    rest=${rest#"${BASH_REMATCH[0]}"}
  done
  [[ $1 != *[[:space:]] ]] || COMP_WORDS+=("")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _epura epura
  echo "${COMPREPLY[*]}"
}

# What stands in the line once the only candidate is taken.
in_fish() { fish --no-config -c 'epura completion fish | source; complete -C $argv[1]' "$1" | cut -f1 | paste -sd' '; }

try() {  # line, wanted by bash, wanted by fish (whole words)
  expect bash "$1" "$2" "$(in_bash "$1")"
  [ -z "$fish" ] || expect fish "$1" "${3-$2}" "$(in_fish "$1")"
}

fish=$(command -v fish) || echo "completion: no fish" >&2
try "epura dr" "draw"
try "epura draw part.stl --crease" "--crease-angle"
try "epura draw --hidden " "none dashed solid" "dashed none solid"
try "epura draw --hidden=da" "dashed" "--hidden=dashed"
try "epura draw --projection cab" "cabinet"
try "epura draw --projection cabinet:an" "angle=" "cabinet:angle="
try "epura draw --projection cabinet:angle=" "45" "cabinet:angle=45"
try "epura draw --projection=cabinet:angle=3" "" ""
try "epura draw --views front,to" "front,top"
# The shell itself knows files: no answer lets readline offer them.
try "epura draw par" "" "part.obj part.stl partition/"
try "epura draw -o part.s" "" "part.stl"
try "epura plugins two" "two-point"

if command -v zsh >/dev/null; then
  epura completion zsh >_epura && zsh -n _epura || { echo "completion: zsh cannot read its script" >&2; status=1; }
else
  echo "completion: no zsh" >&2
fi
exit $status
