"""page_numbers.py ROOT SLIM HAVILAND FANUC SSIK: README and the pages on papers have the numbers of the reports and stores in
these folders, so none of them says other than the program, or less."""
import csv, pathlib, re, sqlite3, sys

root, slim, haviland, fanuc, ssik = map(pathlib.Path, sys.argv[1:])
lost = []
text = lambda page: (root / page).read_text()
table = lambda file: list(csv.DictReader((slim / "tables" / file).open(newline="")))
number = r"(?<![\w.])\d+(?:\.\d+)?(?:e-\d+)?(?![\w]|\.\d)"


def says(page, *numbers):
    """A paragraph, an item of a list or a row of the page has all of them."""
    parts = re.split(r"\n(?=\n|- |\|)", re.sub(r"(?<=\d) (?=\d{3}\b)", "", text(page)))
    if not any(set(map(str, numbers)) <= set(re.findall(number, part)) for part in parts):
        lost.append(f"{page} does not say {', '.join(map(str, numbers))} in one place")


def all_say(paper, *numbers):
    for page in ("README.md", f"docs/papers/{paper}.md"):
        says(page, *numbers)


def tables_of(page):
    """The cells of each table, the row under the head left out."""
    for rows in re.findall(r"(?:^\|.*\n)+", text(page), re.M):
        head, _, *body = [[cell.strip() for cell in row.strip("|\n").split("|")] for row in rows.splitlines()]
        yield head, body


def same(page, report):
    """The page has the report's first sentence; of Slim et al. the scale of its numbers."""
    words = lambda text: " ".join(re.sub(r"\*\*|\]\([^)]*\)|\[", "", text).split())
    first, second = (report / "report.md").read_text().split("\n\n")[:2]
    sentence = second[second.index("Another solver's row"):] if "Slim et al." in first else first.removeprefix("# ")
    sentence = sentence.rstrip(".")
    words(sentence) in words(text(page)) or lost.append(f"{page} does not say: {sentence}")


# Slim et al.: pages have how many statistics are reproduced, and the report's sentence on the scale of that.
reproduced = re.findall(number, (slim / "report.md").read_text().split("\n\n")[1].partition("Another solver's row")[0])
for page in ("README.md", "docs/papers/slim2023.md"):
    same(page, slim)
    says(page, *(n for n in reproduced if n not in ("3", "5.3", "5.2")))  # but for those of the table and sections
wide = re.search(r"Depending on the seed, .* ranges are wider", (slim / "report.md").read_text())
says("docs/papers/slim2023.md", *re.findall(number, wide.group()))
for with_20, with_50 in zip(table("table-3.csv"), table("table-3-50.csv")):
    for quantity in ("position error [cm]", "angles variation [deg]"):
        if with_20["statistic"] == "mean":
            says("docs/papers/slim2023.md", with_20[quantity.replace("[", "printed [")], *(f"{float(row[quantity]):.3g}" for row in (with_20, with_50)))
for claim in table("claims.csv"):
    says("docs/papers/slim2023.md", *re.findall(number, claim["ours"]))
counts = [int(table("multiverse.csv")[0][verdict]) for verdict in ("holds", "fails", "inconclusive")]
for page in ("README.md", "docs/papers/slim2023.md"):
    says(page, sum(counts), *counts, table("multiverse.csv")[0]["most failures with one answer"].split()[0])

# Beeson and Ames: TRAC-IK's rates are the stored ones, one arm's other rates the store's. How many repeat is counted
# in the page's table.
head, arms = next(tables_of("docs/papers/beeson2015.md"))
columns = [head.index(name) for name in ("TRAC-IK", "KDL", "KDL-RR")]
stored = csv.DictReader((root / "results/published/beeson2015/programs.csv").open(newline=""))
told = sorted(arm[columns[0]] for arm in arms)
told == sorted(f"{int(row['solved']) / int(row['n']):.2%}"[:-1] for row in stored) or lost.append("beeson2015.md: other rates than TRAC-IK's stored ones")
repeat = [sum("x" not in arm[i + 1] for arm in arms) for i in columns]
all_say("beeson2015", repeat[0], len(arms))
says("docs/papers/beeson2015.md", len(arms), *repeat)
rates = "SELECT 100 * avg(status = 'ok') FROM current_solves WHERE study = 'beeson2015-fanuc_m430ia2f' AND label IN ('KDL', 'KDL-RR') GROUP BY label"
says("docs/papers/beeson2015.md", *(f"{rate:.1f}" for rate, in sqlite3.connect(fanuc / "store.sqlite").execute(rates)))

# Haviland and Corke: the page's numbers are the store's. A printed one repeats if it lies within the 99 % interval of the
# difference of two such samples with our standard deviation.
store, repeats, tried = sqlite3.connect(haviland / "store.sqlite"), 0, 0
of_solve = {"not solved": "10000.0 * (status <> 'ok')", "iterations": "CASE status WHEN 'ok' THEN evaluations END", "searches": "restarts + 1"}
for study, (head, solvers) in zip(("haviland2023", "haviland2023-searches", "haviland2023-part2"), tables_of("docs/papers/haviland2023.md")):
    for solver in solvers:
        for i in [i for i, name in enumerate(head) if name in of_solve]:
            query = f"WITH v AS (SELECT {of_solve[head[i]]} AS v FROM current_solves WHERE study = ? AND label = ?) SELECT count(v), avg(v), avg(v * v) FROM v"
            n, mean, square = store.execute(query, (study, solver[0])).fetchone()
            told = f"{mean:.{len(solver[i].partition('.')[2])}f}"
            told == solver[i] or lost.append(f"haviland2023.md: {head[i]} of {solver[0]} is {solver[i]}, not {told}")
            of_part_1 = study != "haviland2023-part2"
            tried += of_part_1
            repeats += of_part_1 and abs(mean - float(solver[i + 1].split()[0])) <= 2.576 * (2 * (square - mean**2) / n) ** 0.5
all_say("haviland2023", repeats, tried)
same("docs/papers/haviland2023.md", haviland)

# ssik's README: the page has the table of the program, and both pages the first sentence.
for page in ("README.md", "docs/papers/ssik2026.md"):
    same(page, ssik)
head, arms = next(tables_of("docs/papers/ssik2026.md"))
counted = csv.DictReader((ssik / "tables/answers.csv").open(newline=""))
arms == [[row[name] or "-" for name in head] for row in counted] or lost.append("ssik2026.md: other numbers of answers")
sys.exit("\n".join(lost) or 0)
