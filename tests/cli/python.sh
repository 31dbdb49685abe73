#!/usr/bin/env bash
# results/python/ikbench.py reads what the program writes, and docs/python.md shows it.
source "$(dirname "$0")/common.sh"
source_folder=$(realpath "$scripts/../..")
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
export PYTHONPATH=$source_folder/results/python PYTHONDONTWRITEBYTECODE=1

succeeds run slim2023 --set runs=4 --set path.points=3 --set stop.iterations=5 --no-figures --out out/small

# The page's blocks are one program.
awk '/^```python$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$source_folder/docs/python.md" >page.py
python3 page.py >page.out || fail "the program of docs/python.md ends with $?"
has "$(<page.out)" "72 solves; IK-BA missed by"
has "$(<page.out)" "IK-BA 2 3 "
[ "$(grep -c '^[A-Za-z-]* and [A-Za-z-]* \(better\|worse\|the same\|undecided\)' page.out)" = 15 ] ||
  fail "expected 15 pairs: $(<page.out)"

# It reads the numbers that the program tells: of every solve, and of every judged mean.
succeeds export out/small/store.sqlite -o solves.csv
cat >compare.py <<'PYTHON'
import csv, json, math, sqlite3, ikbench

def same(a, b):
    return a == b or (math.isnan(a) and math.isnan(b))

store = ikbench.Store("out/small")
solves = store.solves()
with open("solves.csv") as file:
    written = list(csv.DictReader(file))
assert len(solves) == len(written) == 72
for mine, theirs in zip(solves, written):
    for column in ("position_error_cm", "variation_deg", "seconds"):
        assert same(mine[column], float(theirs[column] or "nan")), (column, mine[column], theirs[column])
    assert mine["answer_rad"] == [float(theirs[f"answer_rad_{i}"]) for i in range(1, 8)]
    assert mine["solver"] == theirs["solver"] and mine["run"] == int(theirs["run"])
for quantity, column in (("position error [cm]", "position_error_cm"), ("angles variation [deg]", "variation_deg")):
    judged = [one for one in json.load(open("out/small/statistics.json")) if one["quantity"] == quantity]
    assert judged, quantity
    for group in judged[0]["groups"]:
        means = [row[column] for row in store.run_means(column=column) if row["solver"] == group["name"]]
        assert math.isclose(sum(means) / len(means), group["mean"]["value"], rel_tol=1e-12), (column, group["name"])
pairs = ikbench.findings("out/small")
assert {row["verdict"] for row in pairs} and all(list(row) == list(pairs[0]) for row in pairs)
try:
    pairs.frame()
except ImportError:
    pass

def refuses(words, call):
    try:
        call()
    except ikbench.Error as error:
        assert words in str(error) and "\n" not in str(error), error
    else:
        raise AssertionError("accepted; expected: " + words)

refuses("has no study 'none'; it has 'slim2023'", lambda: store.solves("none"))
refuses("'status' is no column of numbers", lambda: store.run_means(column="status"))
refuses("there is no such file", lambda: ikbench.Store("none.sqlite"))
refuses("expected a store that ikbench wrote", lambda: ikbench.Store("solves.csv"))
sqlite3.connect("other.sqlite").execute("CREATE TABLE a (b)")
refuses("a database of another program", lambda: ikbench.Store("other.sqlite"))
with open("out/small/store.sqlite", "rb") as file:
    copy = bytearray(file.read())
copy[60:64] = (99).to_bytes(4, "big")  # user_version
with open("later.sqlite", "wb") as file:
    file.write(copy)
refuses("the store has schema 99", lambda: ikbench.Store("later.sqlite"))

# Damaged rows and files: one sentence that names the file.
def damaged(sql):
    import shutil

    shutil.copy("out/small/store.sqlite", "damaged.sqlite")
    database = sqlite3.connect("damaged.sqlite")
    database.executescript(sql)
    database.close()
    return ikbench.Store("damaged.sqlite")

for sql in (
    "UPDATE solves SET answer_rad = '[1, 2' WHERE run = 2",
    "UPDATE solves SET answer_rad = '5' WHERE run = 2",
    "UPDATE solves SET answer_rad = '[1, \"two\"]' WHERE run = 2",
    "UPDATE solves SET answer_rad = x'00' WHERE run = 2",
    "UPDATE solves SET seconds = 'soon' WHERE run = 2",
    "UPDATE solves SET evaluations = 'many' WHERE run = 2",
    "UPDATE studies SET definition = '{'",
    "ALTER TABLE solves DROP COLUMN counted_by",
    "DROP TABLE series",
):
    refuses("damaged.sqlite: it is damaged (", damaged(sql).solves)
refuses("damaged.sqlite: it is damaged (", damaged("UPDATE studies SET definition = '['").definition)
refuses("damaged.sqlite: it is damaged (", lambda: damaged("DROP TABLE studies").studies)
with open("out/small/store.sqlite", "rb") as file:
    whole = file.read()
with open("cut.sqlite", "wb") as file:
    file.write(whole[: len(whole) // 2])
refuses("cut.sqlite: ", lambda: ikbench.Store("cut.sqlite").solves("slim2023"))
for text in ("[", "5", '{"a": 1}', "[1]", '[{"contrasts": [1]}]', "[" * 100000):
    with open("damaged.json", "w") as file:
        file.write(text)
    refuses("damaged.json: it is damaged (", lambda: ikbench.findings("damaged.json"))
refuses("none.json: ", lambda: ikbench.findings("none.json"))
PYTHON
python3 compare.py || fail "what Python reads is not what the program tells"

# pip installs it from the tree.
if python3 -c 'import pip, setuptools, wheel' 2>/dev/null; then
  cp -r "$source_folder/results/python" package
  python3 -m pip install -q --no-index --no-build-isolation --no-deps --target site ./package >pip.out 2>&1 ||
    fail "pip: $(<pip.out)"
  PYTHONPATH=site python3 -c 'import ikbench; print(ikbench.__file__, ikbench.__version__)' >where ||
    fail "what pip installed cannot be imported"
  has "$(<where)" "site/ikbench.py $("$program" --version | sed -n '1s/^ikbench \([0-9.]*\).*/\1/p')"
fi
