#!/usr/bin/env bash
# Puts meshes of Debian's package libcgal-demo into a folder: real_meshes.sh FOLDER NAME...
# Or all of libcgal-demo, assimp-testmodels and openscad-testing-data: real_meshes.sh --all FOLDER
# (77 if they cannot be had.) The packages are only unpacked, not installed: they would bring all of
# CGAL and Boost with them.
set -euo pipefail

if [[ $1 == --all ]]; then
  mkdir -p "$2"
  cd "$2"
  for package in libcgal-demo assimp-testmodels openscad-testing-data; do
    [[ ! -d $package ]] || continue
    rm -f "$package"_*.deb
    apt-get -q -o APT::Sandbox::User=root download "$package" || exit 77
    dpkg-deb -x "$package"_*.deb "$package.part"
    archive=$package.part/usr/share/doc/libcgal-dev/data.tar.gz
    [[ ! -f $archive ]] || { tar -xzf "$archive" -C "$package.part" && rm "$archive"; }
    rm "$package"_*.deb
    mv "$package.part" "$package"
  done
  exit 0
fi

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
