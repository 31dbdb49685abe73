#!/usr/bin/env bash
# A study to start from: it is written, read again and run, and speaks of no paper unless it is a paper's.
source "$(dirname "$0")/common.sh"

# A short one, with one budget.
succeeds new my.toml
has "$out" "my.toml: damped_least_squares, newton, ik_bat on kuka_iiwa14, 100 runs of one target"
has "$out" "Edit it, then: ikbench run my.toml"
succeeds list studies my.toml
for line in "name = 'my'" "evaluations = 10000" "bounds = 'clamp'" "margin_percent = 5"; do has "$out" "$line"; done
succeeds run my.toml --set runs=3 --no-figures --out my
has_no "$out" "do not spend the same"

# Nothing is overwritten unless it is asked for, and nothing is written that cannot be read.
cp my.toml before.toml
refused 'my.toml is there already; choose another name, or replace it with --force' new my.toml --robot ur5e
cmp my.toml before.toml || fail "a refused study was changed"
succeeds new my.toml --robot ur5e --solver newton --solver "levenberg_marquardt" --force
has "$out" "newton, levenberg_marquardt on ur5e"
ln -s elsewhere.toml link.toml
refused 'link.toml is there already' new link.toml
[ ! -e elsewhere.toml ] || fail "written through a link"
refused 'a study is a file such as my.toml' new my
refused 'did you mean "newton"' new other.toml --solver newtn
refused 'did you mean "ur5e"' new other.toml --robot ur5ee
refused 'did you mean "slim2023"' new other.toml --like slim203
refused 'but this one has no spherical wrist' new other.toml --robot ur5e --solver closed_form
refused '--without-paper' new other.toml --without-paper
refused '--like' new other.toml --like slim2023 --robot ur5e
refused 'without control characters' new $'a\nb.toml'
[ ! -e other.toml ] && [ ! -e $'a\nb.toml' ] || fail "a file was written that the program refuses"
succeeds new 'my "arm".toml'
succeeds list studies 'my "arm".toml'

# An arm of a file is found from the folder of the study.
mkdir arms studies
cp "$scripts/../data/urdf/fetch.urdf" arms
succeeds new studies/theirs.toml --robot arms/fetch.urdf --tip wrist_roll_link --solver newton
grep -q '^robot = "../arms/fetch.urdf"' studies/theirs.toml || fail "the arm is named otherwise: $(<studies/theirs.toml)"
grep -q '^tip = "wrist_roll_link"' studies/theirs.toml || fail "the tip is not there: $(<studies/theirs.toml)"
succeeds list studies studies/theirs.toml

# Like a paper's study it is held against the paper; without the paper nothing speaks of one.
succeeds new paper.toml --like slim2023
has "$out" "makes it a study of its own"
succeeds run paper.toml "${small[@]}" --no-figures --out paper
grep -q 'Dobot' paper/report.md || fail "the report of a paper's study does not speak of the paper"
succeeds new own.toml --like slim2023 --without-paper
has_no "$out" "printed"
succeeds run own.toml "${small[@]}" --no-figures --out own
for file in report.md article.tex report.html; do
  ! grep -i -n 'slim\|dobot\|untestable\|robotics 20' "own/$file" || fail "own/$file speaks of a paper"
done
! grep -i -n 'the paper\|claim \|printed' own/report.md own/article.tex || fail "the report speaks of a paper"
# Others too, whatever their paths and solvers, are studies to start from.
for study in baselines beeson2015 haviland2023 lloyd2022-kdl slim2023-dobot; do
  succeeds new all.toml --like "$study" --without-paper --force
done
