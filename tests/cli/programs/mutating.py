"""A solver whose messages of one kind are mutants of right ones: mutating.py KIND SEED NAME.

KIND is the message that is mutated, SEED decides how. For each solve a line is added to NAME.log: the target, the statuses that
the protocol allows, and the mutant.
"""
import copy, json, math, os, random, sys

KIND, SEED, FILE = sys.argv[1], sys.argv[2], sys.argv[3]
VALUES = (None, True, False, -1, 0, 1, 3.5, -0.0, 1e308, 5e-324, 2**31, 2**64, 10**30, "", "a", "1", "\x00", "\u202e", [], {}, [[]],
          [None], {"a": 1}, [1] * 7, [[0.1] * 7] * 2, "x" * 300, [0] * 2000)
TEXTS = (b"NaN", b"1e999", b"-", b"01", b'"', b"\\", b"[" * 150, b"{", b"}", b"]", b",", b"\x00", b"\xff", b"\xed\xa0\x80", b"\r", b"\n",
         b" ", b"\t", b'"\\ud800"', b"\xef\xbb\xbf", b"//", b"1" * 400, b"\n{", b"9" * 5000)
PROTOCOL_ERROR = ["protocol_error"]


def places(container):
    """Each container in a message, with each of its keys."""
    found = []
    for key in list(container) if isinstance(container, dict) else range(len(container)):
        found.append((container, key))
        if isinstance(container[key], (dict, list)): found += places(container[key])
    return found


def mutant(message, draw):
    """The message as a line, in which up to two values and up to two places of the text are changed."""
    message = copy.deepcopy(message)
    for _ in range(draw.choice((0, 1, 1, 2))):
        container, key = draw.choice(places(message))
        way = draw.randrange(4)
        if way < 2: container[key] = copy.deepcopy(draw.choice(VALUES))
        elif way == 2: del container[key]
        elif isinstance(container, dict):
            container[draw.choice((key.upper(), key + " ", "message", "answers", "seed"))] = container.pop(key)
        if not message: break
    line = json.dumps(message).encode()
    for _ in range(draw.choice((0, 0, 1, 2))):
        at = draw.randrange(len(line) + 1)
        way = draw.randrange(5)
        if way == 0: line = line[:at] + bytes([draw.randrange(256)]) + line[at + 1:]
        if way == 1: line = line[:at]
        if way == 2: line = line[:at] + draw.choice(TEXTS) + line[at:]
        if way == 3: line = line[:at] + line[at + draw.randrange(1, 9):]
        if way == 4: line = line[at:] + line[:at]
    if draw.randrange(60) == 0: line += b" " * 1000001
    return line


def is_number(value): return isinstance(value, (int, float)) and not isinstance(value, bool)
def is_list(value, n): return isinstance(value, list) and len(value) == n and all(v is None or is_number(v) for v in value)


def parsed(line):
    """The object that a line is, by RFC 8259 and the protocol's bounds; None if it is none."""
    def finite(text):
        value = float(text)
        if math.isinf(value): raise ValueError
        return value
    def refused(text): raise ValueError
    try:
        text = line.decode()
        message = json.loads(text, parse_constant=refused, parse_float=finite, parse_int=lambda text: finite(text) and int(text))
        json.dumps(message, ensure_ascii=False).encode()  # refuses half of a surrogate pair
    except (ValueError, RecursionError): return None
    depth = most = 0
    is_text = is_escaped = False
    for c in text:
        if is_escaped: is_escaped = False
        elif c == "\\": is_escaped = is_text
        elif c == '"': is_text = not is_text
        elif not is_text:
            depth += (c in "[{") - (c in "]}")
            most = max(most, depth)
    return message if isinstance(message, dict) and most <= 100 else None


def is_candidates(value):
    if not isinstance(value, list) or not value: return False
    return all(is_list(each, joints) for each in (value if isinstance(value[0], list) else [value]))


def allowed_statuses(answer, problem, error):
    """The statuses that a solve may have that ends with this answer, after an evaluation whose error is given (None if it is not
    that of the start). The list is empty if the time that passed decides."""
    if answer.get("message") == "declined": return ["declined"]
    if answer.get("message") != "solved": return PROTOCOL_ERROR
    if "seed" in answer and not (is_number(answer["seed"]) and answer["seed"] == problem["seed"]): return PROTOCOL_ERROR
    extras = answer.get("extras")
    if not (extras is None or isinstance(extras, dict)): return PROTOCOL_ERROR
    for name, value in (extras or {}).items():
        is_plain = len(name.encode()) <= 200 and not any(ord(c) < 32 or 127 <= ord(c) < 160 for c in name) and name.strip()
        if not is_plain or name.startswith(("refused_", "check_", "invalid: ")) or not (value is None or is_number(value)): return PROTOCOL_ERROR
    if "answers" in answer:
        if not is_candidates(answer["answers"]): return PROTOCOL_ERROR
    elif "q" in answer and not is_list(answer["q"], joints): return PROTOCOL_ERROR
    for name in ("error", "seconds"):
        if not (answer.get(name) is None or is_number(answer[name])): return PROTOCOL_ERROR
    if answer.get("seconds") is not None and not 0 <= answer["seconds"] <= 10: return PROTOCOL_ERROR
    for name in ("iterations", "evaluations"):
        if name in answer and not (is_number(answer[name]) and 0 <= answer[name] <= 1e15): return PROTOCOL_ERROR
    if (answer.get("seconds") or 0) > 0.02: return []  # more than passed, on a machine without other work
    if "answers" in answer or answer.get("q", problem["start"]) != problem["start"]: return ["not_finite", "misreported", "over_budget", "ok",
        "tolerance_missed", "limit_violated"]
    if error is not None and answer.get("error") is not None and abs(answer["error"] - error) > 2e-6: return ["misreported"]
    if any(answer.get(name, 0) >= 1.5 * problem["budget"][name] for name in ("iterations", "evaluations")): return ["over_budget"]
    return ["ok", "tolerance_missed", "limit_violated"]


def write(line):
    sys.stdout.buffer.write(line + b"\n")
    sys.stdout.buffer.flush()


def say(**message): write(json.dumps(message).encode())


def next_message(): return json.loads(sys.stdin.readline() or "null") or sys.exit()


def note(target, statuses, line):
    with open(FILE + ".log", "a") as file: print(json.dumps([target, statuses, repr(line[:1000])]), file=file)


def message_in(line):
    """The message that ikbench reads from what is written; None if it is none, and "" if all of it is ignored."""
    for part in line.split(b"\n"):
        if len(part) > 1000000: return None
        if part[:1] == b"{": return parsed(part[:-1] if part.endswith(b"\r") else part)
    return ""


def lone_mutant(message, draw):
    """A mutant that is one message at most, since what follows an answer belongs to the next solve. It has few names of extras,
    since there may be 50 of them in a study."""
    while True:
        line = mutant(message, draw)
        names = (parsed(line.split(b"\n")[0]) or {}).get("extras")
        if sum(part[:1] == b"{" for part in line.split(b"\n")) < 2 and not (isinstance(names, dict) and set(names) - {"restarts", "a"}):
            return line


def solve(problem):
    draw = random.Random(f"{SEED} {problem['seed']}")
    is_warm_up = problem["seed"] < 3
    mutated = "" if is_warm_up else KIND
    ask = {"message": "evaluate", "candidates": [problem["start"]]}

    def send(line, statuses):  # notes them before it writes, since ikbench ends who writes nonsense
        if not is_warm_up: note(problem["target"]["position"], statuses, line)
        write(line)
        if statuses == ["crashed"]: os._exit(3)

    line = lone_mutant(ask, draw) if mutated == "evaluate" else json.dumps(ask).encode()
    asked = message_in(line)
    if asked == "": return send(line, ["crashed"])
    if asked is None or asked.get("message") != "evaluate" or not is_candidates(asked.get("candidates")):
        return send(line, PROTOCOL_ERROR)
    write(line)
    error = next_message()["errors"][0]
    if asked["candidates"] not in (ask["candidates"], problem["start"]): error = None
    answer = {"message": "solved", "seed": problem["seed"], "q": problem["start"], "error": error, "iterations": 1, "evaluations": 1,
              "seconds": 0.001, "extras": {"restarts": 1}}
    answered = lone_mutant(answer, draw) if mutated == "solved" else json.dumps(answer).encode()
    read = message_in(answered)
    if read == "": return send(answered, ["crashed"])
    send(answered, PROTOCOL_ERROR if read is None else allowed_statuses(read, problem, error))


hello = {"message": "hello", "ikbench": 2, "name": "mutating", "version": "1", "batch": KIND == "batch", "goals": ["position", "pose"],
         "options": [{"name": "w", "type": "number", "default": 0.5, "low": 0, "high": 1, "meaning": "nothing"},
                     {"name": "c", "type": "integer", "default": 3, "low": 0, "high": 9, "meaning": "nothing"},
                     {"name": "way", "choices": ["up", "down"], "default": "up", "meaning": "nothing"}]}
if KIND == "checked": hello = {"message": "hello", "ikbench": 2, "name": "checking"}
draw = random.Random(SEED)
if KIND == "hello":
    first = mutant(hello, draw)
    write(first)
    if message_in(first) == "": os._exit(3)
else: say(**hello)
batches = 0


def write_or_end(line):
    """Writes a mutant, and ends if all of it is ignored, since ikbench would only wait for the timeout."""
    write(line)
    if message_in(line) == "": os._exit(3)


for text in sys.stdin:
    question = json.loads(text)
    if question["message"] == "robot": joints = len(question["joints"])
    if question["message"] == "solve": solve(question)
    if question["message"] == "check":
        write_or_end(mutant({"message": "checked", "valid": False, "why": "left", "numbers": {"lean": 1.5}}, draw))
    if question["message"] == "solve_batch":
        batches += 1
        answers = {"message": "solved_batch", "seconds": 0.001, "answers": [
            {"message": "solved", "seed": each["seed"], "q": each["start"]} for each in question["problems"]]}
        if batches > 1: write_or_end(mutant(answers, random.Random(f"{SEED} {question['problems'][0]['seed']}")))
        else: say(**answers)  # the first is not recorded
