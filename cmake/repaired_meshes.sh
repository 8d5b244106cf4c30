#!/usr/bin/env bash
# Repairs all meshes of three Debian packages and writes docs/repaired-meshes.md:
#   repaired_meshes.sh BUILD [FOLDER]
# The packages are only unpacked, into FOLDER, which is kept if it is given.
set -euo pipefail
build=$1
folder=${2:-$(mktemp -d)}
[[ $# -gt 1 ]] || trap 'rm -rf "$folder"' EXIT
root=$(cd "$(dirname "$0")/.." && pwd)

"$root/cmake/real_meshes.sh" --all "$folder"

cd "$folder"
mapfile -t meshes < <(find . -type f -size -40M \
  \( -iname '*.off' -o -iname '*.obj' -o -iname '*.stl' -o -iname '*.ply' -o -iname '*.3mf' \) |
  LC_ALL=C sort)
{
  cat <<'PAGE'
# Repaired meshes

What `sectile repair` makes of the meshes of Debian's packages libcgal-demo, assimp-testmodels and
openscad-testing-data, by the rule `positive`; meshes that are open are taken with `--close-holes`.
Made by `cmake/repaired_meshes.sh`.

*as it is* says whether `from_mesh` takes the mesh. *points that agree*: of 1,000 random points, half
of them close to faces, those which are in the solid exactly if the winding number of the mesh says
so, computed exactly by a program that shares nothing with the library; "-" where faces were turned
around, holes closed or polygons split, so that the mesh as it is has no winding numbers. *ms*:
processor time of `repair`, all cores together. Solids that did not pass `validate()` would be marked.

PAGE
  "$build"/tests/real/repair_table "${meshes[@]}"
} > "$root/docs/repaired-meshes.md"
