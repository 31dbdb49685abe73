#!/usr/bin/env bash
# A control loop: its table is what the solves and Franka's velocity limits say, computed apart from the exported solves.
source "$(dirname "$0")/common.sh"
loop=(run tracking-panda --set runs=2 --set path.points=1000 --only LM,Newton --set loop.period_ms=0.05)
succeeds "${loop[@]}" --figures path --out loop
succeeds robot franka_panda --urdf
cp .out panda.urdf
succeeds "${loop[@]}" --set robot=panda.urdf --figures none --out of_urdf
has "$out" 'late in a row'
for joints in 0, ''; do  # of the first joint, then of all
  sed "${joints}/velocity=\"[^\"]*\"/s//velocity=\"1e-320\"/" panda.urdf >slow.urdf
  succeeds "${loop[@]}" --set robot=slow.urdf --set runs=1 --set path.points=20 --figures none --out slow
  equal "columns that know what is too fast ($joints)" "$(grep '^|' slow/report.md | grep -c 'too fast')" $((${#joints} / 2))
  [ -z "$joints" ] || has "$(<slow/tables/loop.tex)" "joint 1"
done
for folder in loop of_urdf; do
  python3 - $folder >said <<'END' || fail "$folder: $(<said)"
import csv, itertools, math, sys
rows = lambda name: list(csv.DictReader(open(f"{sys.argv[1]}/{name}")))
solves, period = rows("solves.csv"), 0.05e-3
most = [2.175 * period] * 4 + [2.61 * period] * 3
def numbers(label):
    own = [row for row in solves if row["label"] == label]
    late = [float(row["seconds"]) > period for row in own]
    in_run = [list(zip(*group))[1] for _, group in itertools.groupby(zip([row["run"] for row in own], late), lambda pair: pair[0])]
    row_of = lambda run: max((len(list(group)) for is_late, group in itertools.groupby(run) if is_late), default=0)
    move = lambda row: [abs(float(row[f"answer_rad_{j}"]) - float(row[f"start_rad_{j}"])) for j in range(1, 8)]
    steps = [move(row) for row in own if row["point"] != "1"]
    percent = lambda all: 100 * sum(all) / len(all)
    is_timed = own[0]["timing"] == "clean"
    return [percent([row["status"] != "ok" for row in own]), percent(late) if is_timed else None,
            max(map(row_of, in_run)) if is_timed else None, math.degrees(max(map(max, steps))),
            percent([any(a > b for a, b in zip(step, most)) for step in steps])]
table = rows("tables/loop.csv")
assert [row["solver"] for row in table] != [] and len(table) == 2, table
for row in table:
    told = [float(value) if value else None for value in list(row.values())[1:]]
    own = numbers(row["solver"])
    print(row["solver"], told, own)
    for a, b in zip(told, own, strict=True): assert (a is None and b is None) or abs(a - b) <= 1e-9 * (1 + abs(b))
    assert own[3] > 30 and own[4] > 0, "nobody jumps"
END
done
first=$(sed -n 2p loop/tables/loop.csv | cut -d, -f1)
marked=$(sed -n '/^# late or too fast/,$p' loop/figures/source/path.gp | grep -c '^[-0-9]')
told=$(grep -o '"late":[a-z]*,"too_fast":[a-z]*' loop/report.html | head -n 200 | grep -c true)
[ "$marked" -gt 0 ] && [ "$told" -gt 0 ] || fail "$first: $marked points are marked in the figure, $told on the page"
refused loop.period_ms run baselines --set loop.period_ms=1 --out no
