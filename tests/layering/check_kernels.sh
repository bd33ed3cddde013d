#!/usr/bin/env bash
# Fails with the name of every function that the objects of one kind of processor share with others: the linker keeps
# one of them for all, and it may be one that the processor at hand cannot run.
#   check_kernels.sh PROCESSOR OBJECT...
set -u
processor=$1
shift
shared=$(nm -C --defined-only "$@" | sed -nE 's/^[0-9a-f]+ [A-Zu] //p' |
  grep -vE "(Eigen|holdfast::)_?$processor::|^DW\.ref\.|^__odr_asan\.")
if [ -n "$shared" ]; then
  echo "$shared"
  exit 1
fi
