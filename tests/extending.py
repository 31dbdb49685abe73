"""extending.py PROGRAM CMAKE: every addition of the table of docs/extending.md is one file and one line. In a copy of the
sources each file is added and found by the build, which reads each list, and all of them together leave each room below its
ceiling of lines; arm, study and poses of the page are run."""
import pathlib, re, shutil, subprocess, sys, tempfile

program, cmake = sys.argv[1:]
root = pathlib.Path(__file__).resolve().parents[1]
page = (root / "docs/extending.md").read_text()


def run(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
    done.returncode == 0 or sys.exit(f"{command}: {done.stdout[-2000:]} {done.stderr[-2000:]}")


with tempfile.TemporaryDirectory() as scratch:
    copy, built, added = pathlib.Path(scratch) / "copy", pathlib.Path(scratch) / "built", []
    shutil.copytree(root, copy, ignore=shutil.ignore_patterns(".*", "build", "out", "tests", "pictures"))
    rows = re.findall(r"^\| (an? .*|what .*) \| (.*) \| (.*) \|$", page, re.M)
    len(rows) >= 13 or sys.exit(f"the table has {len(rows)} rows")
    for what, file, line in rows:
        for path in re.findall(r"`([\w/]+\.\w+)`", file):
            if "NAME" not in path:
                (root / path).is_file() or sys.exit(f"{what}: there is no {path}")
                continue
            new = copy / path.replace("NAME", f"added_{len(added)}")
            shutil.copy(min(new.parent.glob("*" + new.suffix), key=lambda f: (f.stat().st_size, f)), new)  # as a beginning is
            added.append(new.name)
        for entry in re.findall(r"`([\w/]+\.(?:inc|bib))`", line):
            found = list(copy.rglob(entry))
            len(found) == 1 or sys.exit(f"{what}: {entry} is {found}")
            for macro in re.findall(r"`([A-Z]+)\(NAME\)`", line):
                f"{macro}(" in found[0].read_text() or sys.exit(f"{what}: no {macro} in {entry}")
                found[0].open("a").write(f"{macro}(added_{len(added) - 1})\n")
    run("bash", root / "tests/tools/size-and-shape", copy)
    run(cmake, "-S", copy, "-B", built, "-G", "Ninja", "-DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON")  # whose programs are of tests
    read = "".join(file.read_text() for pattern in ("build.ninja", "Unity/*.cxx", "*.inc") for file in built.rglob(pattern))
    lost = [name for name in added if name not in read]
    (len(added) >= 6 and not lost) or sys.exit(f"of {added} the build does not find {lost}")

    after = lambda heading, kind: re.search(rf"## {heading}\n.*?```{kind}\n(.*?)```", page, re.S)[1]
    mine = pathlib.Path(scratch) / "mine"
    mine.mkdir()
    (mine / "my_arm.toml").write_text(after("An arm", "toml"))
    study = re.search(r"```toml\n(.*?)```", (root / "docs/reference/study-file.md").read_text(), re.S)[1]
    (mine / "study.toml").write_text(study)
    (mine / "path.csv").write_text(after("Poses of your own", "csv"))
    small = ["--set", "runs=2", "--set", "stop.iterations=5", "--no-report", "--out", "out"]
    run(program, "robot", "my_arm.toml", cwd=mine)
    run(program, "run", "study.toml", "--set", "path.points=3", *small, cwd=mine)
    (mine / "poses.toml").write_text(re.sub(r"(?s)\[path\].*?\n\n", '[path]\nkind = "csv"\nfile = "path.csv"\n\n', study))
    run(program, "run", "poses.toml", "--set", "name=poses", *small, cwd=mine)
