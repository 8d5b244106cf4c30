#!/usr/bin/env bash
# Takes the pictures that differ from those in tests/viewer/reference as the new references:
#   accept_screenshots.sh [NAME...]     names without .png; all that differ if none is given
# Look at them before (the tests say where they are), and at the git diff after.
set -euo pipefail
cd "$(dirname "$0")/.."
made=build/tests/viewer/pictures
kept=tests/viewer/reference

cmake --build build --target reference_test
build/tests/viewer/reference_test >/dev/null || true
shopt -s nullglob
for picture in "$made"/*.png; do
  name=$(basename "$picture" .png)
  case $name in *-difference) continue ;; esac
  if [ $# -gt 0 ] && [[ " $* " != *" $name "* ]]; then continue; fi
  # A palette of 256 colours: a third of the size, and no difference to be seen.
  pngquant --force --strip --speed 1 --nofs --output "$kept/$name.png" 256 -- "$picture"
  rm -f "$picture" "$made/$name-difference.png"
  echo "$kept/$name.png"
done
