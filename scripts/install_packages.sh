#!/usr/bin/env bash
# Installs what building and testing need on Debian 12; does nothing where all is there.
# `install_packages.sh build`: only what building needs, without the tier transient;
# `install_packages.sh transient`: with it.
set -eu

packages=(
  build-essential cmake ninja-build git python3
  nlohmann-json3-dev libvalijson-dev libcli11-dev libfmt-dev libeigen3-dev
  libboost-dev libboost-math-dev libhdf5-dev libsqlite3-dev libssl-dev
)
# OpenFOAM's headers are in no package: scripts/openfoam_headers.sh fetches them.
[ "${1-}" = build ] || packages+=(
  openfoam libopenfoam libliggghts-dev libopenmpi-dev openmpi-bin bzip2
)
[ -n "${1-}" ] || packages+=(
  libgtest-dev libgmock-dev libbenchmark-dev python3-h5py python3-numpy
  clang-format-14 clang-tidy-14 libomp-14-dev gnuplot-nox
  chromium fonts-liberation
  slurmctld slurmd slurm-client munge
)

missing=()
for package in "${packages[@]}"; do
  if ! dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed'; then
    missing+=("$package")
  fi
done
[ ${#missing[@]} -eq 0 ] && exit 0

echo "installing: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "missing packages, and neither root nor sudo: apt-get install ${missing[*]}" >&2
    exit 1
  }
  as_root=(sudo)
fi
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq \
  --no-install-recommends "${missing[@]}"
