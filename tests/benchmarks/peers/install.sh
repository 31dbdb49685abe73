#!/usr/bin/env bash
# Installs what ./benchmark peers measures beside loops by hand: pagmo, as root, and libraries of Python in build/peers/venv,
# each of the version and the bytes that requirements.txt names.
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"/../../.. || exit 2
as_root="" && ((EUID == 0)) || as_root="sudo -n"
apt_get() { $as_root apt-get -qq -o DPkg::Lock::Timeout=300 "$@" >/dev/null; }
dpkg -s libpagmo-dev python3-venv >/dev/null 2>&1 ||
  { apt_get update && apt_get install -y --no-install-recommends libpagmo-dev python3-venv; } || echo "not installed: pagmo" >&2
python3 -m venv build/peers/venv || exit 2
build/peers/venv/bin/python -m pip install --quiet --only-binary :all: --require-hashes \
  --requirement tests/benchmarks/peers/requirements.txt || echo "not installed: libraries of Python" >&2
