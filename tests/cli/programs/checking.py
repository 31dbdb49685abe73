"""A check by the first joint's sign, and a number. Its argument says what goes wrong, if that is so at the fifth answer."""
import json, os, signal, sys, time

FAULT = sys.argv[1]
if FAULT == "begins late": time.sleep(1.5)
if FAULT == "says no hello": sys.exit()
print(json.dumps({"message": "hello", "ikbench": 2, "name": "checking"}), flush=True)
asked = 0
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] != "check": continue
    asked += 1
    assert len(told["target"]["rotation"]) == 9 and len(told["start"]) == len(told["q"])
    valid = {"all": True, "none": False}.get(FAULT, told["q"][0] > 0)
    said = {"message": "checked", "valid": valid, "why": "left", "numbers": {"lean": told["q"][1]}}
    if asked == 5:
        if FAULT == "stops its parent": os.kill(os.getppid(), signal.SIGSTOP)
        if FAULT in ("hangs", "stops its parent"): time.sleep(1000)
        if FAULT == "dies": sys.exit("no more")
        if FAULT == "is nonsense": said = "{"
        if FAULT == "is no verdict": said["valid"] = "yes"
        if FAULT == "says no why": said.update(valid=False, why=" ")
        if FAULT == "lacks the number": said["numbers"] = {}
        if FAULT == "has another number": said["numbers"]["more"] = 1
        if FAULT == "is NaN": said["numbers"]["lean"] = float("nan")
        if FAULT == "is null": said["numbers"]["lean"] = None
    for _ in range(1 + (FAULT == "twice")): print(said if said == "{" else json.dumps(said), flush=True)
