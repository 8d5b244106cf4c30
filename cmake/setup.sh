#!/usr/bin/env bash
# Installs the Debian packages that are missing: setup.sh [build | check]
# `build` (the default) is what building and testing need, `check` also what .ci/run needs.
set -euo pipefail

packages=(g++ cmake ninja-build libtbb-dev libcli11-dev nlohmann-json3-dev libboost-dev
          libtinyobjloader-dev lib3mf-dev libzip-dev libgtest-dev libbenchmark-dev pkg-config
          libglfw3-dev libglm-dev libimgui-dev libfreetype-dev libstb-dev libosmesa6-dev
          libgl1-mesa-dri python3-glad fonts-inter fonts-dejavu-core fonts-font-awesome xvfb xauth
          xdotool)
case "${1:-build}" in
  build) ;;
  check) packages+=(clang-format-14 git dpkg-dev file ccache pngquant) ;;
  *) echo "usage: setup.sh [build | check]" >&2; exit 2 ;;
esac

is_installed() {
  [[ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
[[ ${#missing[@]} -gt 0 ]] || exit 0

as_root=()
if [[ $EUID -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "Missing packages, and no sudo. Run as root: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get -q update
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get -q install -y --no-install-recommends "${missing[@]}"
