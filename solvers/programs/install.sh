#!/usr/bin/env bash
# install.sh [PROGRAM...]: a virtual environment for each program here, with what its head names; needs uv.
cd "$(dirname "${BASH_SOURCE[0]}")" || exit 2
for program in "${@:-with_*.py}"; do
  for file in $program; do
    place=../../build/libraries/${file%.py}
    python=$(sed -n 's/^# requires-python = "==\(.*\)\.\*"$/\1/p' "$file")
    uv venv --quiet --allow-existing ${python:+--python "$python"} "$place" &&
      uv pip install --quiet --only-binary :all: --python "$place/bin/python" --requirements "$file" ||
      echo "not installed: $file" >&2
  done
done
