#!/usr/bin/env bash
# install.sh [PROGRAM...]: a virtual environment for each program here, with what its head names (by uv, which it installs
# into build/uv where there is none), and with_k in Rust (needs cargo).
cd "$(dirname "${BASH_SOURCE[0]}")" || exit 2
(($#)) || set -- with_*.py with_k
code=1  # if none is installed
export PATH=$PATH:$PWD/../../build/uv/bin
command -v uv >/dev/null || { python3 -m venv ../../build/uv && ../../build/uv/bin/pip install --quiet uv; } || exit 2
for file; do
  place=../../build/libraries/$(basename "$file" .py)
  if [[ -d $file ]]; then
    cargo build --quiet --release --manifest-path "$file/Cargo.toml" --target-dir "$place" && code=0 || echo "not installed: $file" >&2
    continue
  fi
  python=$(sed -n 's/^# requires-python = "==\(.*\)\.\*"$/\1/p' "$file")
  if uv venv --quiet --allow-existing ${python:+--python "$python"} "$place" &&
    uv pip install --quiet --only-binary :all: --python "$place/bin/python" --requirements "$file"; then
    code=0
  else
    echo "not installed: $file" >&2
  fi
done
exit $code
