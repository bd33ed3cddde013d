# The packages that a bare Debian 12 or 13 needs to build, test and run Holdfast. This file is sourced, not run.

holdfast_packages=(
  g++ cmake ninja-build ccache
  libeigen3-dev libsuitesparse-dev libopenblas0-pthread
  libexpat1-dev zlib1g-dev liblz4-dev liblzma-dev
  nlohmann-json3-dev libfmt-dev libcli11-dev
  libvtk9-dev libvtk9-qt-dev qtbase5-dev
  libgtest-dev libgmock-dev liblapacke-dev libbenchmark-dev libmumps-seq-dev
  xvfb libgl1-mesa-dri
)

# Prints those of the packages named that are not installed, one a line.
absent_packages() {
  local known installed
  # This fails where a package is not known at all, which is an answer too.
  known=$(dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null) || true
  installed=$(sed -n 's/^installed //p' <<<"$known")
  comm -23 <(printf '%s\n' "$@" | sort -u) <(sort -u <<<"$installed")
}

# Runs a command as root: directly, or through sudo. sudo drops the environment, hence `env`.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    env "$@"
  elif command -v sudo >/dev/null; then
    sudo env "$@"
  else
    echo "error: neither root nor sudo here; ask an administrator for: $*" >&2
    return 1
  fi
}

# Installs what is absent, and says so; asks the network for nothing where all is there.
install_packages() {
  if ! command -v apt-get dpkg-query >/dev/null; then
    echo "== No apt here: taking for granted that the packages of scripts/lib/packages.sh are there"
    return
  fi
  local absent
  mapfile -t absent < <(absent_packages "$@")
  [ ${#absent[@]} -gt 0 ] || return 0
  echo "== Installing ${#absent[@]} packages: ${absent[*]}"
  as_root DEBIAN_FRONTEND=noninteractive apt-get update --quiet </dev/null
  as_root DEBIAN_FRONTEND=noninteractive apt-get install --quiet --yes --no-install-recommends "${absent[@]}" </dev/null
}
