#!/usr/bin/env bash
# Files with the features of public URDF files, held against other kinematics.
source "$(dirname "$0")/common.sh"
python3 "$scripts/urdfs.py" "$program" || fail "see above"
