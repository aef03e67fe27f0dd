# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Common code of the benchmark scripts, which source it. All measurements go into one file as "LABEL KEY VALUE": seconds
# of each stage, whole (wall seconds of the process), core (all stages but read and write), memory (MB).
set -euo pipefail
export LC_ALL=C  # decimal points in any locale
root=$(realpath "$(dirname "$(realpath "${BASH_SOURCE[0]}")")/..")
programs=$root/build/bench/bin
models=$root/build/bench/models
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

die() { echo "$(basename "$0"): $*" >&2; exit 2; }

# build PURPOSE...: installs packages and builds everything in build/bench.
build() {
  "$root/.ci/packages" build "$@"
  (cd "$root" && cmake --preset bench >/dev/null && cmake --build --preset bench >/dev/null)
  mkdir -p "$models"
}

# model_file NAME: prints the path of KIND-N (made by 'scenes'), of FILE+STEPS (made by 'subdivide'), or of a file.
model_file() {
  local name=$1 made
  made=$models/$(basename "$name").ply
  if [ -f "$name" ]; then realpath "$name"; return; fi
  if [ ! -f "$made" ]; then
    case $name in
      *+[0-9]) "$programs/subdivide" "${name%+*}" "${name##*+}" "$made" ;;
      *-[0-9]*) "$programs/scenes" "${name%-*}" "${name##*-}" "$made" ;;
      *) die "'$name' is neither a file, nor FILE+STEPS, nor KIND-N" ;;
    esac
  fi
  echo "$made"
}

# run LABEL COMMAND...: runs the command once and records the measurements.
run() {
  local label=$1 begin end
  shift
  begin=$EPOCHREALTIME
  /usr/bin/time -q -f 'memory %M' -o "$work/time" "$@" 2>"$work/says" || { cat "$work/says" >&2; die "failed: $*"; }
  end=$EPOCHREALTIME
  awk -v label="$label" -v whole="$end - $begin" '
    BEGIN { split(whole, t, " - "); printf "%s whole %.6f\n", label, t[1] - t[2] }
    $1 == "memory" { print label, $1, $2 / 1024; next }
    NF >= 2 && $2 ~ /^[0-9.]+$/ { print label, $1, $2 }
    $3 == "s" && $1 != "read" && $1 != "write" { core += $2 }
    END { print label, "core", core + 0 }' "$work/says" "$work/time" >>"$work/records"
}

draw() { run "$1" "$programs/epura" draw "$2" --hidden dashed -o "$work/$1.svg" --timings "${@:3}"; }

# turns ROUNDS ONE OTHER: calls both in every round, in alternating order, since the first run warms up the second.
turns() {
  local round
  for ((round = 0; round < $1; ++round)); do
    if ((round % 2)); then "$3"; "$2"; else "$2"; "$3"; fi
  done
}

forget() { : >"$work/records"; }

values() { awk -v label="$1" -v key="$2" '$1 == label && $2 == key { print $3 }' "$work/records"; }
middle() { sort -g | awk '{ v[NR] = $1 } END { if (NR) print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2; else print 0 }'; }
median() { values "$1" "$2" | middle; }

# ratio LABEL KEY OTHER KEY: the median of the ratios of alternating runs.
ratio() { paste <(values "$1" "$2") <(values "$3" "$4") | awk '$2 > 0 { print $1 / $2 }' | middle; }

# show FORMAT NUMBER...: like printf, but through awk, so that numbers in any notation are accepted.
show() { awk -v format="$1" 'BEGIN { for (i = 1; i < ARGC; ++i) printf format, ARGV[i] }' "${@:2}"; }

# triangles_of FILE: from its PLY header, or for other formats from OpenMesh.
triangles_of() {
  local count
  count=$(head -c 400 "$1" | grep -a -m1 'element face' | cut -d' ' -f3 || true)
  [ -n "$count" ] || count=$("$programs/openmesh_read" "$1" 2>&1 | awk '$1 == "triangles" { print $2 }')
  echo "$count"
}

# Prints the machine's data, without which a table of times is worthless.
machine() {
  lscpu | awk -F: '/^Model name|^CPU\(s\)|^L2 cache|^L3 cache/ { gsub(/^ +/, "", $2); printf "%s%s: %s", n++ ? ", " : "", $1, $2 }'
  awk '/^MemTotal/ { printf ", memory: %.0f GB", $2 / 1048576 }' /proc/meminfo
  printf ', %s, commit %s%s, load %s\n\n' "$(c++ --version | head -1)" "$(git -C "$root" rev-parse --short HEAD)" \
    "$(git -C "$root" diff --quiet HEAD || echo ' and changes')" "$(cut -d' ' -f1 /proc/loadavg)"
}
