#!/usr/bin/env python3
"""wheel.py ARCHIVE: makes a Python wheel of the program's archive (ikbench-VERSION-linux-MACHINE.tar.gz), beside it.

A wheel is that archive with other names: what is in bin/ are scripts, the rest stands in the same place of the prefix. Its
modules are the helper of programs in Python, which any Python 3 runs, and what makes a function of a notebook a solver.
"""
import base64
import hashlib
import pathlib
import re
import sys
import tarfile
import zipfile

archive = pathlib.Path(sys.argv[1])
version, machine = re.fullmatch(r"ikbench-([\d.]+)-linux-(\w+)\.tar\.gz", archive.name).groups()
info = f"ikbench-{version}.dist-info"
files = {}
with tarfile.open(archive) as tar:
    needed = max(  # of the symbols' versions in the program and its libraries
        (int(minor) for member in tar if member.isfile() and re.search(r"/(bin|lib)/", member.name)
         for minor in re.findall(rb"GLIBC_2\.(\d+)", tar.extractfile(member).read())), default=0)
    linked = {str(pathlib.PurePosixPath(member.name).with_name(member.linkname)) for member in tar if member.issym()}
    for member in tar:
        if not member.isdir() and member.name not in linked:  # a zip has no links: the file, by the name that is asked for
            path = member.name.split("/", 1)[1]
            place = path.replace("bin/", "scripts/", 1) if path.startswith("bin/") else f"data/{path}"
            files[f"ikbench-{version}.data/{place}"] = tar.extractfile(member).read()
files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: ikbench\nRoot-Is-Purelib: false\nTag: py3-none-manylinux_2_{needed}_{machine}\n".encode()
for module in ("ikbench.py", "ikbench_notebook.py"):
    files[module] = files[f"ikbench-{version}.data/data/share/doc/ikbench/solvers/helpers/{module}"]
files[f"{info}/METADATA"] = f"""Metadata-Version: 2.1
Name: ikbench
Version: {version}
Summary: compares inverse-kinematics solvers and judges published claims
License: MIT
Keywords: inverse kinematics,robotics,benchmark,statistics
Classifier: Environment :: Console
Classifier: Operating System :: POSIX :: Linux
Classifier: Topic :: Scientific/Engineering
Requires-Python: >=3.7
Requires-External: gnuplot
Provides-Extra: notebook
Requires-Dist: pandas; extra == "notebook"
Description-Content-Type: text/markdown

The program `ikbench` runs inverse-kinematics solvers on studies and says which is better. Without gnuplot it draws no figures.
The module `ikbench` is what a solver in Python imports. Its `study` compares functions in a notebook with other solvers;
`solves` and `results` are pandas DataFrames.
The pages are in `share/doc/ikbench` of the environment: begin with `README.md` and `docs/tutorial.md`.
""".encode()
digest = lambda data: base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
record = [f"{name},sha256={digest(data)},{len(data)}" for name, data in files.items()] + [f"{info}/RECORD,,"]
files[f"{info}/RECORD"] = ("\n".join(record) + "\n").encode()
wheel = archive.with_name(f"ikbench-{version}-py3-none-manylinux_2_{needed}_{machine}.whl")
with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as out:
    for name, data in files.items():
        entry = zipfile.ZipInfo(name)  # of 1980, so the same archive gives the same bytes
        entry.external_attr = (0o100755 if "/scripts/" in name or ".so" in name else 0o100644) << 16
        out.writestr(entry, data, zipfile.ZIP_DEFLATED)
print(wheel)
