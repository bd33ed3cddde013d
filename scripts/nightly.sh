#!/usr/bin/env bash
# Runs once a night what takes too long for every change: the tests of label `nightly` (meshes that are no part of the
# project, the tour of the window, the core alone with all its tests), the experiments of docs/paper.md, what other
# versions of VTK, Qt and Mesa may do differently on both Debians, each source compiled alone and read by clang-tidy,
# the core, the window and the workers under sanitizers, the batch program under valgrind, and the benchmarks. It
# installs what is missing first (apt). It goes on after a failure, says at the end which parts failed and how long each
# took, and ends with 1 if any did.
# docs/testing.md says more.
#   scripts/nightly.sh [PART...]      PART: tests, paper, bookworm, trixie, sources, lint, sanitizers, window,
#                                     threads, threads-window, valgrind, benchmarks; all if left out
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/lib/packages.sh
. scripts/lib/build.sh
. scripts/lib/bare_system.sh

# configure_release OPTION...
configure_release() {
  install_packages "${holdfast_packages[@]}"
  configure_preset release -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_TESTS=ON "$@"
}
run_tests() {
  configure_release
  build_preset release holdfast_tour
  scripts/test.sh --label-regex nightly
}
# Experiments of docs/paper.md that take seconds, and all benchmarks on small meshes, so that they do not rot.
run_paper() {
  configure_release -DHOLDFAST_BUILD_BENCH=ON
  build_preset release
  ctest --preset release --tests-regex '^paper/|benchmarks$'
}
run_bookworm() { in_bare_system bookworm scripts/test.sh --tests-regex "$by_version"; }
run_trixie() { in_bare_system trixie scripts/test.sh --tests-regex "$by_version"; }
# Headers without a source of their own, too: all others are the first include of theirs.
run_sources() {
  install_packages "${holdfast_packages[@]}"
  configure_preset debug -DHOLDFAST_BUILD_GUI=ON -DHOLDFAST_WITH_CHOLMOD=ON -DHOLDFAST_BUILD_TESTS=ON -DHOLDFAST_BUILD_BENCH=ON
  build_preset debug
  build_preset debug all_verify_interface_header_sets
}
# After `sources`, which makes the sources that Qt generates. 77: the tools are of another version.
run_lint() {
  install_packages clang-format clang-tidy
  scripts/lint.sh || [ $? -eq 77 ]
}
# Addresses, leaks and undefined behaviour of core and batch.
run_sanitizers() { scripts/sanitize.sh; }
run_window() { scripts/sanitize.sh --window; }
run_threads() { scripts/sanitize.sh --threads; }
run_threads_window() { scripts/sanitize.sh --threads --window; }
run_benchmarks() { scripts/bench.sh --benchmark_out=out/benchmarks.json --benchmark_out_format=json; }

# Reads of what was never written, which no sanitizer of ours looks for, on the bundled examples.
run_valgrind() {
  local example status
  install_packages valgrind
  mkdir -p out
  for example in bar.obj:bar plate_unsymmetric.off:plate_unsymmetric.conflict head.ply:head.rigid_eyes; do
    status=0
    valgrind --quiet --error-exitcode=99 build/release/app/holdfast-batch \
      deform "data/${example%%:*}" --constraints "data/${example#*:}.constraints.json" --out out/valgrind.obj || status=$?
    # 4: some constraints contradict others, as they should.
    [ "$status" -eq 0 ] || [ "$status" -eq 4 ] || return "$status"
  done
}

# Tests of what depends on the version of VTK, Qt or Mesa, and is quick: the filter, all pictures, what the window copies.
by_version='^widgets/FilteredGrid|^render/|^window/PictureOfBar|^window/DocumentExports'

parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(tests paper bookworm trixie sources lint sanitizers window threads threads-window valgrind benchmarks)
failed=0
summary=()
for part in "${parts[@]}"; do
  echo "== Nightly: $part"
  start=$SECONDS
  if ("run_${part//-/_}"); then result=passed; else result=FAILED failed=1; fi
  summary+=("$(printf '  %-16s %s in %d min %02d s' "$part" "$result" $(((SECONDS - start) / 60)) $(((SECONDS - start) % 60)))")
done
echo "== Nightly summary"
printf '%s\n' "${summary[@]}"
exit "$failed"
