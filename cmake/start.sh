#!/usr/bin/env bash
# Installs what is missing, builds, computes figures of the paper and Booleans of real meshes into
# out/, and opens the modeller with a sample scene; without a display it draws the scene into a PNG.
set -euo pipefail
cd "$(dirname "$0")/.."

cmake/setup.sh build
cmake --preset release
cmake --build --preset release --target sectile_cli sectile_viewer

sectile=build/cli/sectile
scenes=assets/scenes
mkdir -p out

echo
echo "The paper's figures 1 and 2:"
"$sectile" intersect "$scenes"/fig01-a.obj "$scenes"/fig01-b.obj -o out/fig01.obj
"$sectile" subtract "$scenes"/fig02-a.obj "$scenes"/fig02-b.obj -o out/fig02.obj

cmake/real_meshes.sh out/meshes bunny00 knot1 elephant couplingdown
echo
echo "Real meshes, from Debian's package libcgal-demo:"
"$sectile" subtract out/meshes/bunny00.off out/meshes/knot1.off -o out/bunny-without-knot.off
"$sectile" union out/meshes/elephant.off out/meshes/couplingdown.off -o out/elephant-with-coupling.off

made=(out/fig01.obj out/fig02.obj out/bunny-without-knot.off out/elephant-with-coupling.off)
echo
echo "Read back from the files, with coordinates rounded to doubles:"
for file in "${made[@]}"; do
  "$sectile" check "$file"
done
echo
echo "Made:"
ls -l "${made[@]}"

viewer=build/viewer/program/sectile-viewer
scene=(--sample fig01)
if [[ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]]; then
  echo
  echo "The modeller opens; close its window to go on."
  "$viewer" "${scene[@]}"
else
  echo
  echo "There is no display, so the modeller's window is drawn into a file:"
  "$viewer" "${scene[@]}" --size 1280x800 --screenshot out/sectile-viewer.png
fi
