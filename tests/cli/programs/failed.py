"""failed.py FAULT CHECKS JSON: exactly these checks of check-solver failed, in this order, by words of each."""
import json, sys
fault, expected = sys.argv[1], [words for words in sys.argv[2].split("; ") if words]
failed = [row["check"] for row in json.load(open(sys.argv[3])) if not row["passed"] and (fault in ("late", "hangs") or "50 ms" not in row["check"])]
sys.exit(not (len(failed) == len(expected) and all(words in check for words, check in zip(expected, failed))))
