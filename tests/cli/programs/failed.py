"""failed.py <TABLE: exactly the checks of a line, by words of each, failed in FAULT.said, in this order; then FAULT.code is 1."""
import sys
for fault, checks in (line.rstrip("\n").split("|") for line in sys.stdin):
    expected = [words for words in checks.split("; ") if words]
    code, said = open(fault + ".code").read().strip(), open(fault + ".said").read()
    failed = [row.split(": ")[0] for row in said.replace("\n  ", " ").split("\n") if row.startswith("FAILED")]
    failed = [row for row in failed if fault in ("late", "hangs") or "50 ms" not in row]
    if len(failed) != len(expected) or not all(map(str.__contains__, failed, expected)) or (expected and code != "1"):
        sys.exit(f"{fault}, exit code {code}: {said}")
