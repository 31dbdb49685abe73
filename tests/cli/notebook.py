"""Functions of this process as solvers: notebook.py HELPERS, with ikbench on the PATH; writes into the current folder."""
import contextlib
import io
import math
import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import sys
import threading
import time

sys.path.insert(0, sys.argv[1])
import ikbench

calls = []


def near(problem):  # right where the start is the answer
    calls.append(problem.seed)
    return problem.start


def slow(problem):
    end = time.perf_counter() + 0.002
    while time.perf_counter() < end:
        pass
    return problem.start


def asks(problem):
    errors = problem.evaluate([[x + 0.01 for x in problem.start], [x + 0.02 for x in problem.start]])
    assert len(errors) == 2
    problem.evaluate([problem.start])


def raises(problem):
    raise KeyError("no\nsuch")


def leaves(problem):
    sys.exit("left")


def short(problem):
    return problem.start[1:]


def empty(problem):
    return [math.nan] * len(problem.start)


def odd(problem):
    return {"q": problem.start}


def declines(problem):
    raise ikbench.Declined("not this arm" if len(problem.robot.names) == 6 else "another")


def many(problem):
    return [problem.start, [x + 6.5 for x in problem.start]]


study = {"robot": "ur5e", "search": "pose", "start": "near", "near_deg": 0.0001, "seed": 3,
         "path": {"kind": "random", "points": 1}, "stop": {"evaluations": 1000, "tolerance_cm": 0.1, "tolerance_deg": 0.1}}


def rows(folder, columns, label):
    with contextlib.closing(sqlite3.connect(f"{folder}/store.sqlite")) as store:
        return store.execute(f"SELECT {columns} FROM current_solves WHERE label = ? ORDER BY run, point", [label]).fetchall()


def statuses(folder, label):
    return {status for status, in rows(folder, "status", label)}


def complaint(function, kind):
    try:
        function()
    except kind as error:
        return str(error)
    raise AssertionError(f"no {kind.__name__}")


# Functions and a solver of ikbench, twice each, with answers, times and evaluations as programs have.
result = ikbench.study({"near": near, "slow": slow, "asks": asks, "many": many, "LM": "levenberg_marquardt",
                        "DLS": {"solver": "damped_least_squares"}}, out="first", runs=8, **study)
assert result.folder == os.path.abspath("first")
for label in ("near", "slow", "asks", "many", "LM", "DLS"):
    assert statuses("first", label) == {"ok"}, (label, statuses("first", label))
    assert len(rows("first", "run", label)) == 8
assert len(set(calls)) >= 8
assert all(0 < seconds < wall for seconds, wall in rows("first", "seconds, wall_seconds", "slow"))
assert all(cpu > seconds / 2 for seconds, cpu in rows("first", "seconds, cpu_seconds", "slow"))  # of this process
assert rows("first", "counted_by, evaluations", "asks")[0] == ("ikbench", 3)
assert str(result) == repr(result) and result.headline in str(result).replace("\n  ", " ")
table = result._repr_html_()
assert table.count("<tr>") == 7 and "<td>slow</td>" in table and result.headline.split(" ")[0] in table

# The answers are those of a program with the same function.
pathlib.Path("program.py").write_text(f"""import sys
sys.path.insert(0, {sys.argv[1]!r})
import ikbench
ikbench.run("near", lambda robot: robot, lambda robot, problem: problem.start)
""")
ikbench.study({"near": {"process": [sys.executable, "program.py"]}}, out="program", runs=8, **study)
same = "target_position_m, start_rad, answer_rad, status, evaluations, counted_by"
assert rows("program", same, "near") == rows("first", same, "near")

# What is solved once is solved again by a function, whose parts are not seen, and not by a solver of ikbench.
before = len(calls)
shutil.copytree("first", "second")
ikbench.study({"near": near, "LM": "levenberg_marquardt"}, out="second", runs=8, **study)
assert len(calls) >= before + 8
with contextlib.closing(sqlite3.connect("second/store.sqlite")) as store:
    solves = dict(store.execute("SELECT label, count(*) FROM solves GROUP BY label"))
assert (solves["near"], solves["LM"]) == (16, 8), solves

# What goes wrong ends as of programs; the first exception of each is shown whole.
with contextlib.redirect_stderr(io.StringIO()) as shown:
    wrong = ikbench.study({"raises": raises, "leaves": leaves, "short": short, "empty": empty, "odd": odd, "declines": declines,
                           "LM": "levenberg_marquardt"}, out="wrong", runs=7, **study)
for label, status in {"raises": "crashed", "leaves": "crashed", "short": "protocol_error", "empty": "not_finite",
                      "odd": "crashed", "declines": "declined", "LM": "ok"}.items():
    found = statuses("wrong", label)
    assert found == {status}, (label, found)
assert shown.getvalue().count("Traceback") == 3 and "in raises" in shown.getvalue()
assert "raises, leaves, short and odd gave no answer" in str(wrong)

# Nothing else is taken, and nothing is left behind.
for solvers, keys, words in ((["LM"], {}, "by their labels"), ({}, {}, "by their labels"), ({3: near}, {}, "by their labels"), ({"a": 3}, {}, "expected a function"),
                             ({"a": near}, {"jobs": 2}, "one function at a time"), ({"a": near}, {"runs": object()}, "no value")):
    assert words in complaint(lambda: ikbench.study(solvers, **{**study, **keys}), TypeError), words
for keys, words in (({"robot": "ur5x"}, "ur5x"), ({"rum": 3}, "rum"), ({"runs": 0}, "runs"), ({"robot": 'ur"\n5\x7fe'}, "ur")):
    text = complaint(lambda: ikbench.study({"a": near}, **{**study, **keys}), ValueError)
    assert words in text and "notebook.toml" not in text, text
assert "nosuch" in complaint(lambda: ikbench.study({"a": "nosuch"}, **study), ValueError)

# One that does not return ends the study, and what is stored is kept; so does an interrupt.
hang = threading.Event()


def stops(problem):
    if problem.seed not in seeds and len(seeds) >= 4:
        hang.wait(100)
    seeds.add(problem.seed)
    return problem.start


signal.signal(signal.SIGINT, signal.default_int_handler)  # a job in the background begins with SIGINT ignored
for way in ("timeout", "interrupt"):
    seeds, began = set(), time.perf_counter()
    if way == "interrupt":
        threading.Timer(3, os.kill, (os.getpid(), signal.SIGINT)).start()
    kind, timeout = (TimeoutError, 1) if way == "timeout" else (KeyboardInterrupt, 60)
    text = complaint(lambda: ikbench.study({"stops": stops, "LM": "levenberg_marquardt"}, out=way, timeout=timeout, runs=20,
                                           **study), kind)
    print(way, f"{time.perf_counter() - began:.1f} s")
    assert os.path.abspath(way) in text
    assert 0 < len(rows(way, "run", "stops")) < 20
hang.set()
kept = complaint(lambda: ikbench.study({"slow": lambda problem: time.sleep(2)}, timeout=0.5, runs=3, **study), TimeoutError)
assert pathlib.Path(kept.split(" is in ")[1], "store.sqlite").exists()

# A store's functions cannot be called from elsewhere, and a pipe that is none is not inherited.
again = subprocess.run([ikbench._program(), "run", "first/store.sqlite", "--out", "again", "--start-programs"], capture_output=True, text=True)
assert again.returncode == 1 and "call ikbench.study" in again.stderr.replace("\n  ", " "), again.stderr
for pipes in ("", "x", "10", "0 1", "10 11", "10 11 12", "99999999999 5"):
    again = subprocess.run([ikbench._program(), "check-solver", "--", sys.executable, sys.argv[1] + "/ikbench_notebook.py"],
                           capture_output=True, text=True, env={**os.environ, "IKBENCH_RELAY": pipes})
    assert again.returncode == 1 and "IKBENCH_RELAY" in again.stdout, (pipes, again)

# Two studies at once do not mix, and a temporary folder goes with its result.
results = {}


def one(name, away):
    results[name] = ikbench.study({"it": lambda problem: [x + away for x in problem.start]}, runs=8, **study)


threads = [threading.Thread(target=one, args=each) for each in (("right", 0), ("wrong", 1))]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
assert statuses(results["right"].folder, "it") == {"ok"} and "ok" not in statuses(results["wrong"].folder, "it")
folder = results.pop("right").folder
import gc
gc.collect()
assert not os.path.exists(folder)

# DataFrames, where pandas is.
try:
    import pandas
except ImportError:
    assert "pip install pandas" in complaint(lambda: result.solves, ImportError)
    assert "pip install pandas" in complaint(lambda: result.pairs, ImportError)
else:
    assert len(result.solves) == 48 and isinstance(result.solves, pandas.DataFrame)
    assert set(result.pairs["verdict"]) and len(result.pairs) == len(ikbench.results("first"))
    print("pandas", pandas.__version__)
