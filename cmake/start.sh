#!/usr/bin/env bash
# Installs what is missing, builds, and computes the first figures of the paper and Booleans of
# real meshes into out/.
set -euo pipefail
cd "$(dirname "$0")/.."

cmake/setup.sh build
cmake --preset release
cmake --build --preset release --target sectile_cli

sectile=build/cli/sectile
scenes=assets/scenes
mkdir -p out

echo
echo "The paper's figures 1 and 2:"
"$sectile" intersect "$scenes"/fig01-a.obj "$scenes"/fig01-b.obj -o out/fig01.obj
"$sectile" subtract "$scenes"/fig02-a.obj "$scenes"/fig02-b.obj -o out/fig02.obj

cmake/real_meshes.sh out/meshes bunny00 elephant knot1 couplingdown anchor_dense
echo
echo "Real meshes, from Debian's package libcgal-demo:"
"$sectile" subtract out/meshes/bunny00.off out/meshes/knot1.off -o out/bunny-without-knot.off
"$sectile" union out/meshes/couplingdown.off out/meshes/anchor_dense.off \
  out/meshes/elephant.off -o out/coupling-with-anchor-and-elephant.off

echo
echo "Are they legal solids again?"
for file in out/*.obj out/*.off; do
  "$sectile" check "$file"
done
echo
echo "Made:"
ls -l out/*.obj out/*.off
