#!/usr/bin/env bash
# Puts meshes of Debian's package libcgal-demo into a folder: real_meshes.sh FOLDER NAME...
# The package is only unpacked, not installed: it would bring all of CGAL and Boost with it.
set -euo pipefail
folder=$1
shift

wanted=()
for name in "$@"; do
  [[ -e "$folder/$name.off" ]] || wanted+=("data/meshes/$name.off")
done
[[ ${#wanted[@]} -gt 0 ]] || exit 0
mkdir -p "$folder"

archive=/usr/share/doc/libcgal-dev/data.tar.gz
if [[ ! -r "$archive" ]]; then
  unpacked=$(mktemp -d)
  trap 'rm -rf "$unpacked"' EXIT
  download() { (cd "$unpacked" && apt-get -q -o APT::Sandbox::User=root download libcgal-demo); }
  if ! download; then
    as_root=()
    [[ $EUID -eq 0 ]] || as_root=(sudo)
    "${as_root[@]}" apt-get -q update
    download
  fi
  dpkg-deb -x "$unpacked"/libcgal-demo_*.deb "$unpacked"
  archive=$unpacked$archive
fi
tar -xzf "$archive" -C "$folder" --strip-components=2 "${wanted[@]}"
