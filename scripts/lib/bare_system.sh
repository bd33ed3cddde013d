# Commands in a bare Debian of a given release, in a folder of its own. This file is sourced, not run, after
# scripts/lib/packages.sh. The root of the project must be the working folder. It needs root rights.

# Prints where this system gets its packages from.
package_mirror() {
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | head -n 1
}

# Makes a bare Debian in a folder, with this machine's way to the packages.
make_bare_system() {
  local suite=$1 root=$2
  install_packages debootstrap
  echo "== Making a bare $suite in $root"
  mkdir -p "$root"
  debootstrap --variant=minbase "$suite" "$root" "$(package_mirror)" >"$root.log" 2>&1 || {
    tail -n 3 "$root.log"
    return 1
  }
  cp /etc/apt/apt.conf.d/99* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
}

# in_bare_system SUITE COMMAND...     for example: in_bare_system trixie scripts/test.sh -R FilteredGrid
# Runs it on what is committed. The system is made by the first call; what was built in it stays for the next.
in_bare_system() {
  local suite=$1 root=$PWD/build/systems/$1
  shift
  if [ "$(id -u)" -ne 0 ]; then
    echo "error: only root can enter another system; run this as root" >&2
    return 1
  fi
  # debootstrap is done when it has made this.
  [ -e "$root/etc/apt/sources.list" ] || make_bare_system "$suite" "$root" || return
  cp /etc/resolv.conf /etc/hosts "$root/etc/"
  [ -d "$root/root/holdfast" ] || git clone --quiet . "$root/root/holdfast"
  git push --quiet --force "$root/root/holdfast" HEAD:refs/heads/committed
  git -C "$root/root/holdfast" checkout --quiet --force --detach committed
  # Its mounts end with it.
  unshare --mount env --ignore-environment HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 bash -c '
    set -e
    root=$1
    shift
    mount -t proc proc "$root/proc"
    mount --bind /dev "$root/dev"
    exec chroot "$root" bash -c "cd /root/holdfast && exec \"\$@\"" in_bare_system "$@"' in_bare_system "$root" "$@"
}
