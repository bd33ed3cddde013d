#!/usr/bin/env bash
# Deforms one mesh in many ways, one process each, as many at a time as there are cores. `holdfast-batch` is on PATH.
#   variants.sh MESH FOLDER CONSTRAINTS...      writes a mesh and a report for each CONSTRAINTS to FOLDER
# Ends with 123 if one of them ends with another code than 0 (docs/errors.md); all others are finished all the same.
set -euo pipefail
export mesh=$1 folder=$2
mkdir -p "$folder"
printf '%s\0' "${@:3}" | xargs -0 -n 1 -P "$(nproc)" bash -c '
  name=$(basename "$1" .constraints.json)
  holdfast-batch deform "$mesh" --constraints "$1" --out "$folder/$name.${mesh##*.}" --report "$folder/$name.json" --quiet' bash
