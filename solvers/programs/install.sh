#!/usr/bin/env bash
# install.sh [PROGRAM...]: a virtual environment for each program here in Python, with what its head names (by uv, which it
# installs into build/uv where there is none); each in C++, with the sources that its head names (needs g++, Eigen, KDL, NLopt,
# Boost; by pip); and with_k in Rust (needs cargo), as its Cargo.lock says. Heads name a library's version; what it stands on is
# the newest of the date below.
as_of=2026-11-30
cd "$(dirname "${BASH_SOURCE[0]}")" || exit 2
(($#)) || set -- $(printf '%s\n' with_*.py | grep -v torch) *.cpp with_k  # torch takes 6 GB
here=$PWD code=1  # if none is installed
export PATH=$PATH:$PWD/../../build/uv/bin
command -v uv >/dev/null || { python3 -m venv ../../build/uv && ../../build/uv/bin/pip install --quiet uv; } || exit 2
compiled() {  # FILE PLACE
  local source flags
  source=$(sed -n 's/^\/\/ source = //p' "$1") flags=$(sed -n 's/^\/\/ flags = //p' "$1" | paste -sd' ')
  rm -rf "$2" && mkdir -p "$2/nanobind" && cd "$2" || return  # an older version's sources would be compiled, too
  [[ -z $source ]] || { python3 -m pip download --quiet --no-deps --no-binary "${source%==*}" "$source" &&
    tar -xzf ./*.tar.gz --strip-components 1; } || return
  printf '#include <cstdlib>\n#define PyMem_RawCalloc std::calloc\n#define PyMem_RawFree std::free\n' >Python.h
  printf '#include <stdexcept>\nnamespace nanobind { using value_error = std::runtime_error; }\n' >nanobind/nanobind.h
  eval "g++ -std=c++17 -O3 -DNDEBUG -w -I $here/../helpers -o program $here/$1 $flags" \
    -I /usr/include/eigen3
}
installed() {  # FILE PLACE
  local python
  case $1 in
    *.cpp) compiled "$@" ;;
    *.py)
      python=$(sed -n 's/^# requires-python = "==\(.*\)\.\*"$/\1/p' "$1")
      uv venv --quiet --allow-existing ${python:+--python "$python"} "$2" &&
        uv pip install --quiet --only-binary :all: --exclude-newer "$as_of" --python "$2/bin/python" --requirements "$1" ;;
    *) cargo build --quiet --release --locked --manifest-path "$1/Cargo.toml" --target-dir "$2" ;;
  esac
}
for file; do
  (installed "$file" "../../build/libraries/$(basename "$file" .py)") && code=0 || echo "not installed: $file" >&2
done
exit $code
