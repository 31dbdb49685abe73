"""failed.py <TABLE: exactly the checks of a line, by words of each, failed in FAULT.json, in this order; then FAULT.code is 1."""
import json, sys
for fault, checks in (line.rstrip("\n").split("|") for line in sys.stdin):
    expected = [words for words in checks.split("; ") if words]
    code, rows = open(fault + ".code").read().strip(), json.load(open(fault + ".json"))
    failed = [row["check"] for row in rows if not row["passed"] and (fault in ("late", "hangs") or "50 ms" not in row["check"])]
    if len(failed) != len(expected) or not all(map(str.__contains__, failed, expected)) or (expected and code != "1"):
        sys.exit(f"{fault}, exit code {code}: {rows}")
