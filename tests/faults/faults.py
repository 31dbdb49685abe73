#!/usr/bin/env python3
"""Each call for a file fails: once, with all later calls of its name, for want of room (a quota), or by a signal. The command
then ends well, or in one sentence, which speaks of no damage. A store that was there keeps its rows. The same command, given
again, makes the same as without a fault.

  faults.py PROGRAM FAILING_CALL                     a drawn sample of the calls, as ./check does
  IKBENCH_ALL=yes faults.py PROGRAM FAILING_CALL     each of them, as ./check --all does

IKBENCH_FAULTS_SEED=N draws the sample of another time.
"""
import concurrent.futures
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

program, failing_call = (str(pathlib.Path(each).resolve()) for each in sys.argv[1:3])
seconds = float("inf") if os.environ.get("IKBENCH_ALL") else 25
work = pathlib.Path(tempfile.mkdtemp())

STUDY = """name = "few"
robot = "kuka_iiwa14"
search = "all_joints"
runs = 2
path = { kind = "random", points = 8 }
stop = { iterations = 8 }
solvers = [{ label = "DLS", solver = "damped_least_squares" }, { solver = "random_search" }]
"""


def called(words, **changes):
    return subprocess.run([program, *map(str, words)], cwd=work, capture_output=True, text=True, timeout=60,
                          env={**os.environ, **changes}, stdin=open(work / "long.csv"))


def made(words):
    result = called(words)
    assert result.returncode == 0, (words, result.stderr)
    return result.stdout


def fingerprint(store):
    return made(["export", store, "--format", "fingerprint"])


HOWS = ("once", "lasting", "quota", "interrupted")  # failing_call.cpp says what they mean
# What a command makes in a folder OUT, in which the case "go on" finds the store of the first shard.
CASES = {
    "run": (["run", "few.toml", "--figures", "none", "--out", "OUT"], lambda out, said: fingerprint(out / "store.sqlite")),
    "go on": (["run", "few.toml", "--figures", "none", "--out", "OUT"], lambda out, said: fingerprint(out / "store.sqlite")),
    "merge": (["merge", "OUT", "shards"], lambda out, said: fingerprint(out / "store.sqlite")),
    "report": (["report", "whole/store.sqlite", "--figures", "none", "--out", "OUT"],
               lambda out, said: [(out / name).read_text() for name in ("report.md", "solves.csv")]),
    "export": (["export", "whole/store.sqlite"], lambda out, said: said),
    "stats": (["stats", "long.csv", "--label", "columns", "--run", "row", "--better", "smaller"], lambda out, said: said),
    "stats -": (["stats", "-", "--label", "columns", "--run", "row", "--better", "smaller"], lambda out, said: said),
}


def begin(case, out):
    if case == "go on":
        shutil.copytree(work / "shards/1", out)


def rows(store):
    """The solves of a store, with their times, which no second solve repeats."""
    return set(made(["export", store]).splitlines())


def is_told(result, call):
    """Whether the command ended as a fault of the disk should: with exit code 2 and one sentence, which speaks of no damage.
    A name that cannot be looked at is one that is not there, a mistake; SQLite forgets why it could not open a file; and
    where a write cannot be undone, the next reader says so, as after a kill."""
    sentence = " ".join(result.stderr.split())
    may_be_mistake = call in ("stat", "open64") or "half-written" in sentence
    if result.returncode != 2 and not (result.returncode == 1 and may_be_mistake):
        return False
    return sentence.count("ikbench: ") + sentence.count("left out: ") == 1 and not re.search("damaged|internal", sentence)


def fault(case, how, number, right):
    """None where the call was not reached or cannot fail so, else what is wrong, which may be nothing."""
    words, what_of = CASES[case]
    out, log = work / f"{case}-{how}-{number}", work / f"{case}-{how}-{number}.call"
    words = [out if word == "OUT" else word for word in words]
    begin(case, out)
    begun = rows(out / "store.sqlite") if out.exists() else set()
    result = called(words, LD_PRELOAD=failing_call, IKBENCH_FAILS=str(number), IKBENCH_HOW=how, IKBENCH_CALLS=str(log))
    call = log.read_text()
    place = f"{case}: call {number}, {call}, fails ({how})"
    sentence = " ".join(result.stderr.split())
    try:
        if call.isdigit():
            return None
        if result.returncode == 0:
            if what_of(out, result.stdout) != right:
                return f"{place}: exit code 0, and something else is made"
        elif not is_told(result, call):
            return f"{place}: exit code {result.returncode}: {sentence}"
        elif what_of(out, made(words)) != right:
            return f"{place}, {sentence}: the same command then makes something else"
        if begun and not begun <= rows(out / "store.sqlite"):
            return f"{place}: rows are lost"
    except Exception as error:
        return f"{place}: {error} (code {result.returncode}: {sentence})"
    finally:
        shutil.rmtree(out, ignore_errors=True)
        log.unlink()
    return ""


def main():
    (work / "few.toml").write_text(STUDY)
    (work / "long.csv").write_text("A,B\n" + "".join(f"{i + 0.5},{i + 1.5}\n" for i in range(1, 10001)))
    made(["run", "few.toml", "--figures", "none", "--out", "whole"])
    for i in 1, 2:
        made(["run", "few.toml", "--shard", f"{i}/2", "--out", f"shards/{i}", "--no-report"])
    jobs, right = [], {}
    for case, (words, what_of) in CASES.items():
        out = work / "right"
        begin(case, out)
        said = called([out if word == "OUT" else word for word in words], LD_PRELOAD=failing_call, IKBENCH_FAILS="0",
                      IKBENCH_CALLS=str(work / "calls"))
        assert said.returncode == 0, said.stderr
        right[case] = what_of(out, said.stdout)
        shutil.rmtree(out, ignore_errors=True)
        jobs += [(case, how, number) for how in HOWS for number in range(1, int((work / "calls").read_text()) + 1)]
    seed = int(os.environ.get("IKBENCH_FAULTS_SEED", time.time_ns() % 10**9))
    random.Random(seed).shuffle(jobs)
    end = time.monotonic() + seconds

    def tried(job):
        return fault(*job, right[job[0]]) if time.monotonic() < end else None

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = [each for each in pool.map(tried, jobs) if each is not None]
    wrong = [each for each in found if each]
    print(f"{len(found)} of {len(jobs)} calls failed, IKBENCH_FAULTS_SEED={seed}: {len(wrong)} faults")
    print("\n".join(sorted(wrong)))
    return 1 if wrong or not found else 0


try:
    sys.exit(main())
finally:
    shutil.rmtree(work)
