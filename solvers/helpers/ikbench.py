"""What a Python program has to say to ikbench (docs/reference/protocol.md). A library takes ten lines:

    import ikbench, some_library

    def prepare(robot):  # once; what it returns goes to solve
        return some_library.from_urdf(robot.urdf, robot.base_link, robot.tip_link)

    def solve(library, problem):  # joint values, or a list of such answers, or None where there is none
        return library.ik(problem.matrix, problem.start)

    ikbench.run("some_library", prepare, solve, goals=["pose"])

It tells ikbench how long `solve` took, and turns angles that are outside their limits back by whole turns. Numbers in
`problem.extras`, by name, are kept beside the answer; `setup_s`, how long `prepare` took, is one."""
import functools, io, json, math, os, pathlib, random, resource, shutil, subprocess, sys, tempfile, time


def solves(store, study=None):
    """The solves of a study, a pandas DataFrame: of a store.sqlite, or of the folder that `ikbench run` wrote."""
    import pandas
    store = pathlib.Path(store, "store.sqlite") if pathlib.Path(store).is_dir() else store
    here = os.path.dirname(sys.executable)  # a wheel's program stands beside Python
    program = shutil.which("ikbench", path=os.pathsep.join([here, os.environ.get("PATH", "")])) or "ikbench"
    said = subprocess.run([program, "export", store, *(["--study", study] if study else [])], capture_output=True, text=True)
    if said.returncode:
        raise ValueError(said.stderr.strip())
    return pandas.read_csv(io.StringIO(said.stdout))


def results(folder, table="findings"):
    """The findings of a report, or another table of its results.json, a pandas DataFrame."""
    import pandas
    return pandas.DataFrame(json.loads(pathlib.Path(folder, "results.json").read_text())[table])


class Declined(Exception):
    """Raised by prepare or solve: why this arm or target cannot be solved."""


try:  # how long this thread has waited for a processor that others had (Linux)
    _schedule = open("/proc/thread-self/schedstat", "rb", buffering=0)
except OSError:
    _schedule = None


class _Clock:
    """Seconds since it was made, without those in which its thread waited for a processor; no fewer than the process, its
    threads and child processes computed, and no more than passed."""

    def __init__(self):
        self._waited, self._computed, self._began = self._waits(), self._computes(), time.perf_counter()

    def _waits(self):
        return int(os.pread(_schedule.fileno(), 99, 0).split()[1]) * 1e-9 if _schedule else 0

    def _computes(self):
        children = resource.getrusage(resource.RUSAGE_CHILDREN)
        return time.process_time() + children.ru_utime + children.ru_stime

    def wall(self):
        return time.perf_counter() - self._began

    def seconds(self):
        wall, computed = self.wall(), self._computes() - self._computed
        return min(wall, max(wall - (self._waits() - self._waited), computed))


class _Members:
    def __init__(self, members):
        for key, value in members.items():
            setattr(self, key, _Members(value) if key in ("budget", "tolerance") else value)


class Robot(_Members):
    """The members of the message `robot`; `names`, `lower` and `upper` of its joints (None: it turns without end)."""

    def __init__(self, message):
        super().__init__(message)
        self.names, self.lower, self.upper = ([joint[key] for joint in self.joints] for key in ("name", "lower", "upper"))
        self.turns = [joint["type"] == "revolute" for joint in self.joints]

    @functools.cached_property
    def file(self):
        """A file with its URDF text, which is there as long as this object."""
        self._folder = tempfile.TemporaryDirectory()
        name = os.path.join(self._folder.name, "arm.urdf")
        with open(name, "w") as file:
            file.write(self.urdf)
        return name

    def require(self, *, turning=False, bounded=False):
        """Declines coupled joints, and if asked those that slide, or turn without end."""
        if any(joint["type"] == "coupled" for joint in self.joints):
            raise Declined("coupled joints")
        if turning and not all(self.turns):
            raise Declined("joints that turn, alone")
        if bounded and None in self.lower:
            raise Declined("joints with limits, alone")


class Answer(_Members):
    """The members of the message `check`: `q`, `start`, and the target as `position`, `rotation`, 3 rows of 3, and `matrix`,
    4 rows of 4."""

    def __init__(self, message):
        super().__init__(message)
        self.position, turn = self.target["position"], self.target.get("rotation", [1, 0, 0, 0, 1, 0, 0, 0, 1])
        self.rotation = [turn[0:3], turn[3:6], turn[6:9]]
        self.matrix = [row + [x] for row, x in zip(self.rotation, self.position)] + [[0, 0, 0, 1]]


class Problem(Answer):
    """The members of the message `solve`; of a pose also `matrix`, 4 rows of 4, and `rotation`, 3 rows of 3."""

    def __init__(self, message, ask):
        super().__init__(message)
        self.extras = {}
        self.random, self._ask, self.evaluated = random.Random(self.seed), ask, False
        self.clock = _Clock()

    def left(self):
        """Seconds of its budget that are left, or fewer while there are some; infinite where there is no budget."""
        by_the_wall = (self.budget.seconds or math.inf) - self.clock.wall()
        return by_the_wall if by_the_wall > 0 else self.budget.seconds - self.clock.seconds()

    def starts(self):
        """Where to begin: the start, then random values inside the limits, while time is left (without a budget of time
        twenty)."""
        yield self.start
        for _ in range(10**9 if self.budget.seconds else 19):
            if self.left() <= 0:
                return
            yield [self.random.uniform(low, high) for low, high in zip(self.lower, self.upper)]

    def evaluate(self, candidates):
        """Their errors, None of one beyond the budget; or None where the solve is over, so return."""
        self.evaluated = True
        told = self._ask({"message": "evaluate", "candidates": [_numbers(q) for q in candidates]})
        return None if told["over"] else told["errors"]


def inside(q, turns, lower, upper, start=None):
    """Turns angles by whole turns to where they are nearest to the start, if there is one, and those that are outside
    then to where they are nearest to the middle; what is 7e-7 outside, by single precision or other digits of a limit,
    comes inside. A value too few or too many stays, for ikbench to tell."""
    def one(x, turn, low, high, near):
        if turn and near is not None and math.isfinite(x):
            x = near + math.remainder(x - near, 2 * math.pi)
        is_near = lambda: low - 7e-7 <= x <= high + 7e-7
        if turn and math.isfinite(x) and not is_near():
            x = (low + high) / 2 + math.remainder(x - (low + high) / 2, 2 * math.pi)
        return min(max(x, low), high) if is_near() else x
    starts = start or [None] * len(lower)
    return [one(*each) for each in zip(q, turns, lower, upper, starts)] if len(q) == len(lower) else q


def _numbers(values):  # JSON has no others than finite ones
    return [float(x) if math.isfinite(x) else None for x in values]


def _option(name, value):
    default, low, high, meaning = value if isinstance(value, tuple) else (value, -math.inf, math.inf, name)
    option = {"name": name, "meaning": meaning}
    if isinstance(default, list):
        return {**option, "default": default[0], "choices": default}
    bounds = {key: bound for key, bound in (("low", low), ("high", high)) if math.isfinite(bound)}
    return {**option, "type": "integer" if isinstance(default, int) else "number", "default": default, **bounds}


def _messages():  # what says one
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what a library prints is no message

    def say(message):
        out.write(json.dumps(message) + "\n")
        out.flush()
    return say


def _plain(text):
    return "".join(c if c.isprintable() else " " for c in str(text)).encode()[:200].decode(errors="ignore")


def check(function, prepare=lambda robot: robot, *, version=""):
    """A study's [check]: says of each answer that reached its target what function(prepared, answer) returns: True, or why
    it is not valid, a few words; or that and its numbers by name: return True, {"clearance_mm": 3.2}."""
    say = _messages()
    say({"message": "hello", "ikbench": 2, "name": function.__name__, "version": version})
    for line in sys.stdin:
        told = json.loads(line)
        if told["message"] == "robot":
            prepared = prepare(Robot(told))
            continue
        said = function(prepared, Answer(told))
        why, numbers = said if isinstance(said, tuple) else (said, {})
        valid = not isinstance(why, str) and bool(why)
        if not (valid or why):
            raise TypeError(f"the check returned {why!r}; expected True, or why the answer is not valid")
        say({"message": "checked", "valid": valid, "why": "" if valid else _plain(why),
             "numbers": dict(zip(numbers, _numbers(numbers.values())))})


def run(name, prepare, solve=None, *, solve_batch=None, version="", options={}, goals=["position", "axis", "pose"]):
    """Says hello and answers until the input ends. `options` by name: a default, or (default, low, high, meaning); a
    list has the choices, the default first. Their values are robot.options. `solve_batch` gets a list of problems and
    gives a list, or rows, of answers; each problem's budget of time is then that of all."""
    solve = solve or (lambda prepared, problem: solve_batch(prepared, [problem])[0])
    say = _messages()

    def ask(message):
        say(message)
        return json.loads(sys.stdin.readline() or sys.exit())

    say({"message": "hello", "ikbench": 2, "name": name, "version": version, "goals": goals,
         "options": [_option(*each) for each in options.items()], **({"batch": True} if solve_batch else {})})

    def answered(problem, q):
        answer = {"message": "solved", "seed": problem.seed}
        if not problem.evaluated:  # else ikbench's time is in it
            problem.extras["setup_s"] = setup
        if problem.extras:
            answer["extras"] = dict(zip(problem.extras, _numbers(problem.extras.values())))
        own = lambda q, start=None: _numbers(
            inside([float(x) for x in q], robot.turns, problem.lower, problem.upper, start))
        q = None if isinstance(q, (list, tuple)) and not q else q
        if isinstance(q, (list, tuple)) and hasattr(q[0], "__len__"):
            answer["answers"] = [own(each, problem.start) for each in q]
        elif q is not None or not problem.evaluated:
            answer["q"] = own(problem.start if q is None else q)
        return answer

    for line in sys.stdin:
        told = json.loads(line)
        try:
            if told["message"] == "robot":
                robot, prepared, clock = Robot(told), None, _Clock()
                try:
                    prepared, why = prepare(robot), None
                except Declined as declined:
                    why = declined
                setup = clock.seconds()
                continue
            if why is not None:
                raise Declined(why)
            if told["message"] == "solve_batch":
                problems = [Problem(each, None) for each in told["problems"]]
                for problem in problems:
                    problem.budget.seconds *= len(problems)
                clock = _Clock()
                found = solve_batch(prepared, problems)
                seconds = clock.seconds()
                if len(found) != len(problems):
                    raise ValueError(f"{len(found)} answers of {len(problems)} problems")
                say({"message": "solved_batch", "seconds": seconds, "answers": list(map(answered, problems, found))})
                continue
            problem = Problem(told, ask)
            q = solve(prepared, problem)
            seconds = problem.clock.seconds()
            say(answered(problem, q) | ({} if problem.evaluated else {"seconds": seconds}))
        except Declined as declined:
            say({"message": "declined", "why": _plain(declined)})
