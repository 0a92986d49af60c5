#!/bin/bash
# A sweep as a Slurm job array: shards without MPI, on nodes that share the folder of the results.
#
#   sbatch docs/slurm-shards.sh configs/poisson-tiles.toml out/poisson-tiles
#
# Eight shards, each on a node or a part of one. The shard that ends last writes the results and the report. When a node
# dies, or the time runs out, submit the same line again: finished work is kept, and only what was in hand is lost.
#SBATCH --job-name=poissonlab
#SBATCH --array=1-8
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=8
#SBATCH --time=04:00:00
#SBATCH --output=poissonlab-%A-%a.log
set -euo pipefail

config=${1:?usage: sbatch slurm-shards.sh CONFIG OUT}
out=${2:?usage: sbatch slurm-shards.sh CONFIG OUT}

# Kernels are compiled once a task, in a folder on the node's own disk that goes with the task.
POCL_CACHE_DIR=$(mktemp -d)
export POCL_CACHE_DIR
trap 'rm -rf "$POCL_CACHE_DIR"' EXIT

build/release/poissonlab run "$config" --out "$out" \
  --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --threads "$SLURM_CPUS_PER_TASK"
