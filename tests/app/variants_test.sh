#!/usr/bin/env bash
# Fails unless examples/variants.sh deforms a mesh in four ways, variants.sbatch in the same without Slurm, bit for bit,
# and both say that one has failed.
#   variants_test.sh BATCH-PROGRAM ROOT
set -eu
PATH="$(dirname "$1"):$PATH"
cd "$2/examples"
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

twists=(../data/bar.twist_*.constraints.json)
./variants.sh ../data/bar.obj "$out/local" "${twists[@]}"
for job in "${!twists[@]}"; do
  SLURM_ARRAY_TASK_ID=$job bash variants.sbatch ../data/bar.obj "$out/jobs" "${twists[@]}"
done
for twist in "${twists[@]}"; do
  name=$(basename "$twist" .constraints.json)
  cmp "$out/local/$name.obj" "$out/jobs/$name.obj"
  grep -q '"status": "ok"' "$out/local/$name.json"
done
code=0
./variants.sh ../data/bar.obj "$out/failing" ../data/none.constraints.json "${twists[0]}" 2>"$out/error" || code=$?
[ "$code" -eq 123 ] && grep -q none.constraints.json "$out/error" && cmp "$out/local/bar.twist_180.obj" "$out/failing/bar.twist_180.obj"
