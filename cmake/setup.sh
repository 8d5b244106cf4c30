#!/usr/bin/env bash
# Installs the Debian packages that are missing: setup.sh [build | check]
# `build` (the default) is what building and testing need, `check` also what .ci/run needs.
set -euo pipefail

packages=(g++ cmake ninja-build libtbb-dev libcli11-dev nlohmann-json3-dev libboost-dev
          libtinyobjloader-dev lib3mf-dev libzip-dev libgtest-dev libbenchmark-dev pkg-config
          libglfw3-dev libglm-dev libimgui-dev libfreetype-dev libstb-dev libgl1-mesa-dri libegl1
          libegl-mesa0 python3-glad fonts-inter fonts-dejavu-core fonts-font-awesome xvfb xauth
          xdotool)
case "${1:-build}" in
  build) ;;
  check) packages+=(clang lld libclang-rt-dev clang-format-14 git dpkg-dev file pngquant) ;;
  *) echo "usage: setup.sh [build | check]" >&2; exit 2 ;;
esac

is_installed() {
  [[ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

as_root=()
need_root() {
  [[ $EUID -ne 0 ]] || return 0
  if ! command -v sudo >/dev/null; then
    echo "Missing packages, and no sudo. Run as root: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if [[ ${#missing[@]} -gt 0 ]]; then
  need_root
  "${as_root[@]}" apt-get -q update
fi
# Pictures without a display: EGL draws them where Debian has no OSMesa any more.
if ! is_installed libosmesa6 && apt-cache show libosmesa6 >/dev/null 2>&1; then
  missing+=(libosmesa6)
fi
# Debian 13 has another clang-format: see .ci/check_format.
if ! apt-cache show clang-format-14 >/dev/null 2>&1; then
  for i in "${!missing[@]}"; do
    [[ "${missing[i]}" != clang-format-14 ]] || unset "missing[i]"
  done
fi
[[ ${#missing[@]} -gt 0 ]] || exit 0

need_root
echo "Installing ${missing[*]}"
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get -q install -y --no-install-recommends "${missing[@]}"
