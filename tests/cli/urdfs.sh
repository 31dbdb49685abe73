#!/usr/bin/env bash
# Files with the features of public URDF files, held against other kinematics, and run.
source "$(dirname "$0")/common.sh"
cp "$root"/tests/data/urdf/*.urdf "$scripts"/programs/snapped/*.urdf .
python3 "$scripts/urdfs.py" "$program" *.urdf || fail "see above"
