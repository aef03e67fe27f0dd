#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A batch as an array of jobs of a real Slurm:  tests/slurm.sh EPURA
# Two nodes on this machine draw 40 parts, or 200 with EPURA_AT_LENGTH; one is killed half way, and its task is queued again. The drawings must be
# those of a single process. Skipped (77) where Slurm is not installed or cannot run.
set -uo pipefail
epura=$(realpath "$1")
samples=$(realpath "$(dirname "$(realpath "$0")")/../samples")
PATH=$(dirname "$epura"):/usr/sbin:$PATH
scratch=$(mktemp -d)
parts=${EPURA_AT_LENGTH:+200}
parts=${parts:-40}

skip() {
  echo "skipped: $*"
  exit 77
}

fail() {
  echo "slurm: $*" >&2
  tail -n 20 "$scratch"/log/* "$scratch"/out-*.txt >&2 2>/dev/null
  exit 1
}

stop() {
  for file in "$scratch"/*.pid; do
    [ -s "$file" ] && kill "$(cat "$file")" 2>/dev/null
  done
  sleep 0.5
  rm -rf "$scratch"
}

free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

[ "$(id -u)" = 0 ] || skip "needs to be root"
for program in munged slurmctld slurmd sbatch sinfo python3; do
  command -v "$program" >/dev/null || skip "$program is not installed (packages slurm-wlm, munge)"
done
trap stop EXIT

mkdir "$scratch"/{state,log,d1,d2}
host=$(hostname -s)
cat >"$scratch/slurm.conf" <<EOF
ClusterName=t
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=$(free_port)
AuthType=auth/munge
AuthInfo=socket=$scratch/munge.socket
CryptoType=crypto/munge
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/%n
SlurmctldPidFile=$scratch/control.pid
SlurmdPidFile=$scratch/%n.pid
SlurmctldLogFile=$scratch/log/control
SlurmdLogFile=$scratch/log/%n
SlurmdTimeout=5
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
ReturnToService=2
NodeName=d1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(free_port) CPUs=1
NodeName=d2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(free_port) CPUs=1
PartitionName=p Nodes=d1,d2 Default=YES MaxTime=10 State=UP
EOF
export SLURM_CONF=$scratch/slurm.conf
head -c 128 /dev/urandom >"$scratch/munge.key"
chmod 400 "$scratch/munge.key"
munged --force --key-file="$scratch/munge.key" --socket="$scratch/munge.socket" --pid-file="$scratch/munge.pid" \
  --log-file="$scratch/log/munge" --seed-file="$scratch/munge.seed" 2>/dev/null || skip "munge does not run here"
slurmctld 2>/dev/null || skip "slurmctld does not run here"
slurmd -N d1 2>/dev/null && slurmd -N d2 2>/dev/null || skip "slurmd does not run here"
for _ in $(seq 40); do
  [ "$(sinfo -h -o %D -t idle 2>/dev/null)" = 2 ] && break
  sleep 0.5
done
[ "$(sinfo -h -o %D -t idle 2>/dev/null)" = 2 ] || skip "the nodes do not come up here"

mkdir "$scratch/parts"
for number in $(seq $parts); do
  { cat "$samples/models/bearing.obj"; echo "# $number"; } >"$scratch/parts/part-$number.obj"
done
cd "$scratch" || exit 2
epura batch parts -o 'whole/{folder}/{name}.svg' --views front,top,left,isometric >/dev/null || fail "a single process fails"
sbatch --array=1-4 --output="$scratch/out-%a.txt" --parsable "$samples/batch/slurm.sh" parts shards >/dev/null ||
  fail "sbatch fails"
# The second node dies when its task is at work, with all that runs on it.
for _ in $(seq 300); do
  task=$(pgrep -f "^/bin/bash $scratch/d2/job" | head -n 1)
  [ -n "$task" ] && [ "$(find shards -name '*.svg' 2>/dev/null | wc -l)" -ge $((parts / 10)) ] && break
  sleep 0.05
done
[ -n "$task" ] || fail "the second node gets no task"
kill -9 "$(cat d2.pid)" "$(ps -o ppid= -p "$task" | tr -d ' ')" "-$(ps -o pgid= -p "$task" | tr -d ' ')"
for _ in $(seq 400); do
  [ -z "$(squeue -h 2>/dev/null)" ] && break
  # Slurm lets two minutes pass before it begins again.
  waiting=$(squeue -h -t pending -o %A 2>/dev/null)
  [ -n "$waiting" ] && scontrol update JobId="${waiting%%$'\n'*}" StartTime=now 2>/dev/null
  sleep 0.5
done
[ -z "$(squeue -h)" ] || fail "tasks are left: $(squeue -h)"
grep -qi requeu log/control || fail "no task was queued again"
epura batch --merge shards >/dev/null || fail "the manifests cannot be joined"
diff -r whole/parts shards/parts >/dev/null || fail "the drawings differ from those of a single process"
echo "$parts drawings by 4 tasks on 2 nodes, one killed: equal to those of a single process"
