#!/usr/bin/env bash
# Draws the pictures of the README: pictures.sh [FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-docs/images}
viewer=build/viewer/program/sectile-viewer
mkdir -p "$folder"

"$viewer" --sample fig01 --size 1280x800 --screenshot "$folder/modeller.png"
"$viewer" --sample fig13 --phase null_edges --size 1280x800 --screenshot "$folder/steps.png"
for phase in reduction vertex_vertex joining components; do
  "$viewer" --sample fig01 --phase "$phase" --exploded 0.4 --no-interface --size 480x360 \
    --screenshot "$folder/$phase.png"
done
