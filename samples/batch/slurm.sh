#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# An array of jobs for Slurm:  sbatch --array=1-8 slurm.sh FOLDER OUTPUT
# A task that is lost with its node is queued again, and draws only what is not yet drawn. Afterwards:
#   epura batch --merge OUTPUT --report OUTPUT/index.html
#SBATCH --requeue
#SBATCH --cpus-per-task=1
set -euo pipefail
epura batch "$1" -o "$2/{folder}/{name}.svg" --views front,top,left,isometric \
  --shard auto --workers "${SLURM_CPUS_PER_TASK:-1}" --job-time 600 --progress never
