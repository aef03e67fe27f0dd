#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Several machines by GNU parallel, which share a folder:  parallel.sh FOLDER OUTPUT MACHINE...
set -euo pipefail
folder=$1 output=$2
shift 2
parallel --sshlogin "$(IFS=,; echo "$*")" --workdir . --halt soon,fail=1 \
  epura batch "$folder" -o "'$output/{folder}/{name}.svg'" --views front,top --shard "{}/$#" ::: $(seq $#)
epura batch --merge "$output" --report "$output/index.html"
