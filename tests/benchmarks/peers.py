#!/usr/bin/env python3
"""Prints, as Markdown, how long PSO and DE take here and by the programs in peers/, and whether their errors are the same: peers.py HOME OUT

A peer is measured between two runs of ours, five times; of both, the clock runs around one call. Draws OUT/peers.svg.
"""
import json, math, os, shutil, sqlite3, subprocess, sys
from bisect import bisect_left, bisect_right
from collections import Counter
from pathlib import Path
from statistics import median, quantiles

home, out = map(Path, sys.argv[1:])
REPEATS, FAR_CM, EVALUATIONS = 5, 0.01, 4020
LABELS = {"PSO": "PSO.random=per_joint", "DE": "DE.weight_drawn=never"}  # the equations as all have them
AGAIN = "draws again outside limits"
PEERS = {  # what differs from ours, or an algorithm that it lacks
    "hand": ("C++ by hand", {}),
    "pagmo": ("pagmo", {"PSO": "starts with speed, stops at limits", "DE": AGAIN}),
    "numpy": ("NumPy by hand", {"PSO": "a better one leads the next iteration"}),
    "pygmo": ("pygmo", {"PSO": "starts with speed, stops at limits, a better one leads the next iteration", "DE": AGAIN}),
    "scipy": ("SciPy, vectorized", {"PSO": None, "DE": "starts by Latin hypercube, " + AGAIN}),
    "mealpy": ("mealpy", {"PSO": f"starts with speed, {AGAIN}, moves only to better", "DE": "forces no joint, replaces at once"}),
    "pymoo": ("pymoo", {"PSO": "starts by Latin hypercube, draws speeds again outside limits", "DE": "draws again between parent and limit"})}


def ours(label, seed, runs=20):
    """Of each solve: seconds, error [cm], evaluations; of each point: target and place of the wrist centre, and joints 1 to 4."""
    shutil.rmtree(out / "ours", ignore_errors=True)
    subprocess.run([home / "build/release/ikbench", "run", "slim2023", "--only", label, "--set", LABELS[label], "--set", f"seed={seed}",
                    "--set", f"runs={runs}", "--no-report", "--out", out / "ours"], check=True, stdout=subprocess.DEVNULL)
    store = sqlite3.connect(out / "ours" / "store.sqlite")
    wrist = lambda flange: [x + h for x, h in zip(json.loads(flange), (0, 0, 0.126))]  # the tool points down
    points = [(wrist(target), wrist(place), json.loads(joints)[:4]) for target, place, joints in store.execute(
        "SELECT target_position_m, reached_position_m, answer_rad FROM current_solves WHERE run = 1 ORDER BY point")]
    return store.execute("SELECT seconds, position_error_cm, evaluations FROM current_solves").fetchall(), points


def theirs(peer, label, seed, points):
    """Its version, and of each solve seconds, error [cm], evaluations; nothing where it is not installed."""
    is_cpp = peer in ("hand", "pagmo")
    program = [home / "build/peers/peers"] if is_cpp else [home / "build/peers/venv/bin/python", Path(__file__).parent / "peers/peers.py"]
    lines = "".join(" ".join(map(repr, target + joints)) + "\n" for target, _, joints in points)
    ran = program[0].exists() and subprocess.run([*program, peer, label, str(seed), "100" if is_cpp else "1"], input=lines, text=True,
                                                 capture_output=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    if not ran or "ModuleNotFoundError" in ran.stderr or ran.stdout.startswith("\n"):
        return "", []
    assert ran.returncode == 0, f"{peer}: {ran.stderr}"
    version, *rows = ran.stdout.splitlines()
    rows = [list(map(float, row.split())) for row in rows]
    each = len(rows) // len(points)  # a place, then its solves
    assert all(math.dist(row, place) < 1e-12 for row, (_, place, _) in zip(rows[::each], points)), f"the arm of {peer} is another"
    return f" ({version})", [(s, 100 * e, n) for i, (s, e, n) in enumerate(rows) if i % each]


def p_of_same(a, b):
    """Mann and Whitney's test, normal, corrected for ties: of true and false it is the z test of two shares."""
    both, n, m = sorted(a + b), len(a), len(b)
    u = sum(bisect_left(both, x) + bisect_right(both, x) + 1 for x in a) / 2 - n * (n + 1) / 2
    ties = sum(t ** 3 - t for t in Counter(both).values()) / ((n + m) * (n + m - 1))
    return math.erfc(abs(u - n * m / 2) / math.sqrt(n * m / 6 * (n + m + 1 - ties) or 1))


def short(x):
    return f"{float(f'{x:.3g}'):g}"


def p_text(p):
    return f" ({p:.2g})" if p > 1e-15 else " (< 1e-15)"


def row(name, pairs, solves, reference, differs):
    """A line of the table; pairs are the times of a solve by it and by ours [s]."""
    assert {n for *_, n in solves} == {EVALUATIONS}, f"{name} makes other evaluations"
    errors = [error for _, error, _ in solves]
    far = [error > FAR_CM for error in errors]
    p = lambda a, of: p_text(p_of_same(a, [of(e) for e in reference])) if reference else ""
    ratios = [it / our for it, our in pairs]
    print(f"| {name} | {short(median(ratios))}{f' ({short(min(ratios))}-{short(max(ratios))})' if reference else ''} "
          f"| {1e3 * median(it for it, _ in pairs):.3g} | {100 * sum(far) / len(far):.3g}{p(far, lambda e: e > FAR_CM)} "
          f"| {', '.join(f'{q:.2g}' for q in quantiles(errors, n=4))}{p(errors, float)} | {differs} |", flush=True)


def draw(times):
    """One line a library, with the times of a solve [s] by each algorithm."""
    names = [name for name in ("ikbench", *(name for name, _ in PEERS.values())) if any(name == of for _, of in times)]
    (out / "peers.gp").write_text(f"""set terminal svg size 560,{24 * len(names) + 70} dynamic font 'Liberation Sans,12' background '#ffffff'
set output '{out}/peers.svg'
set logscale x
set xrange [0.05:]
set yrange [{len(names) - 0.5}:-0.5]
set ytics ({", ".join(f"'{name}' {i}" for i, name in enumerate(names))}) scale 0
set border 1
set tics nomirror
set grid xtics lc rgb '#dddddd' lt 1
set xlabel 'time of a solve with {EVALUATIONS} evaluations [ms]'
""" + "".join(f"${of} << END\n" + "".join(f"{1e3 * median(t)} {names.index(name)} {1e3 * min(t)} {1e3 * max(t)}\n" for (label, name), t in
                                         times.items() if label == of) + "END\n" for of in LABELS) + """
plot $PSO using 1:($2-0.13):3:4 with xerrorbars pt 7 ps 0.7 lc rgb '#0072b2' title 'PSO', \\
  $DE using 1:($2+0.13):3:4 with xerrorbars pt 5 ps 0.7 lc rgb '#d55e00' title 'DE'
""")
    subprocess.run(["gnuplot", "-d", out / "peers.gp"], check=True)


cpu = next((line.split(": ")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "")
print(f"{cpu}, one core; load {os.getloadavg()[0]:.1f}. Joints 1 to 4 of a KUKA iiwa 14, 20 points of a helix, 20 candidates, "
      f"{EVALUATIONS} evaluations; 10000 solves in C++, 100 in Python; {REPEATS} repeats: median (least-most).")
times, missing = {}, set()
for label in LABELS:
    all_ours, points = ours(label, 1, 500)
    print(f"\n| {label} | times ours | ms | % above 0.1 mm (p) | quartiles of the error, cm (p) | not as ours |\n|---|--:|--:|--:|--:|---|")
    row("ikbench", [(s, s) for s, *_ in all_ours], all_ours, [], "")
    reference = [error for _, error, _ in all_ours]
    for peer, (name, differs) in PEERS.items():
        solves, pairs, our_times = [], [], []
        for repeat in range(1, REPEATS + 1):
            before = ours(label, 2 * repeat)[0]
            version, more = theirs(peer, label, 100000 * repeat, points) if differs.get(label, "") is not None else ("", [])
            if not more:
                break
            after = ours(label, 2 * repeat + 1)[0]
            solves += more
            pairs.append((median(s for s, *_ in more), median(s for s, *_ in before + after)))
        if not pairs:
            missing |= {name} if differs.get(label, "") is not None else set()
            continue
        row(name + version, pairs, solves, reference, differs.get(label, ""))
        times.setdefault((label, "ikbench"), []).extend(our for _, our in pairs)
        times[label, name] = [its for its, _ in pairs]
for name in sorted(missing):
    print(f"not installed: {name}; ./setup --with-peers installs it", file=sys.stderr)
if not times:
    sys.exit(1)
draw(times)
