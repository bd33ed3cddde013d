# Functions by which scripts configure and build. This file is sourced, not run. The root of the project must be the
# working folder.

# Memory that may still be used, in MiB: the machine's, or less where a container is given less.
available_memory() {
  local machine limit used
  machine=$(($(sed -n 's/^MemAvailable: *\([0-9]*\) kB/\1/p' /proc/meminfo) / 1024))
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || echo max)
  used=$(cat /sys/fs/cgroup/memory.current 2>/dev/null || echo 0)
  if [ "$limit" != max ] && [ $(((limit - used) / 1024 ** 2)) -lt "$machine" ]; then
    machine=$(((limit - used) / 1024 ** 2))
  fi
  echo "$machine"
}

# Compilers to run at once: one a core, as far as 2 GiB for each go (rounded: a machine sold as 4 GiB offers less).
build_jobs() {
  local cores by_memory
  cores=$(nproc)
  by_memory=$((($(available_memory) + 1024) / 2048))
  [ "$by_memory" -ge 1 ] || by_memory=1
  [ "$by_memory" -lt "$cores" ] && echo "$by_memory" || echo "$cores"
}

# The CMake options that put ccache before the compilers, where there is one and it has a place to write.
ccache_options() {
  local place=${CCACHE_DIR:-${HOME:-}}
  if command -v ccache >/dev/null && [ -n "$place" ] && { [ ! -e "$place" ] || [ -w "$place" ]; }; then
    echo -DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
}

# configure_preset PRESET [OPTION...]
configure_preset() {
  local preset=$1 options
  shift
  read -ra options <<<"$(ccache_options)"
  echo "== Configuring build/$preset"
  cmake --preset "$preset" "${options[@]}" "$@"
}

# build_preset PRESET [TARGET]
build_preset() {
  local preset=$1 jobs
  shift
  jobs=$(build_jobs)
  echo "== Building build/$preset, $jobs at a time"
  cmake --build --preset "$preset" --parallel "$jobs" ${1:+--target "$1"}
}
