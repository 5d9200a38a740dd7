#!/usr/bin/env bash
# The manual's recipes for many sources are run as they stand: GNU parallel, and Slurm with all of it on this machine: recipes.sh RELIEVO BUILD.
# Exits 77 (skipped) where parallel, slurm-wlm or munge are not installed, or Slurm cannot be started (it wants root).
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2
for program in parallel sbatch slurmd slurmctld munged; do
  if ! PATH=$PATH:/usr/sbin command -v "$program" >/dev/null; then
    echo "skipped: $program is not installed (parallel, slurm-wlm, munge)"
    exit 77
  fi
done
if [ "$(id -u)" != 0 ]; then
  echo 'skipped: Slurm is started as root'
  exit 77
fi
export PATH=$(dirname "$relievo"):$PATH:/usr/sbin
work=$build/clients/recipes
rm -rf "$work"
mkdir -p "$work/materials" "$work/state" "$work/spool"
cd "$work"
for sample in bricks cobblestones hammered; do
  relievo export "sample:$sample@64" --target textures -o "materials/$sample" --quiet
done

# The line of the manual that holds $1.
recipe() { grep -E "^    .*$1" "$here/../../resources/help/targets.md" | sed 's/^ *//'; }
expect_all() { # what each recipe has to leave
  for sample in bricks cobblestones hammered; do
    if ! find exported -path "*$sample*" -name '*.tres' | grep -q .; then
      echo "$1: nothing was exported of $sample"
      find exported | head -40
      exit 1
    fi
  done
  echo "$1: 3 materials"
  rm -rf exported
}

line=$(recipe 'parallel relievo')
bash -c "$line" >/dev/null 2>"$work/parallel.txt" || { cat "$work/parallel.txt"; exit 1; }
expect_all "GNU parallel $(parallel --version | sed -nE '1s/.* ([0-9]+)$/\1/p')"

host=$(hostname -s)
cat >slurm.conf <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.txt
SlurmdLogFile=$work/slurmd.txt
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
CONF
export SLURM_CONF=$work/slurm.conf
if ! munge -n >/dev/null 2>&1; then
  install -d -o munge -g munge -m 755 /run/munge
  runuser -u munge -- munged
fi
stop() { for pid in slurmd slurmctld; do [ ! -s "$work/$pid.pid" ] || kill "$(cat "$work/$pid.pid")" || true; done; }
trap stop EXIT
slurmctld
slurmd
for _ in $(seq 30); do
  [ "$(sinfo -h -o %t 2>/dev/null | head -1)" != idle ] || break
  sleep 1
done
if [ "$(sinfo -h -o %t | head -1)" != idle ]; then
  echo "skipped: Slurm's node does not come up here, see $work/slurmd.txt"
  exit 77
fi
line=$(recipe 'sbatch --array')
bash -c "${line/sbatch /sbatch --wait }" >sbatch.txt || { cat slurm-*.out sbatch.txt; exit 1; }
expect_all "Slurm $(sbatch --version | sed 's/.* //'), $(ls slurm-*.out | wc -l) tasks"
