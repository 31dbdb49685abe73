"""Functions of this process as solvers of a study: `ikbench.study` (ikbench.py).

ikbench starts this file as a program, a relay for each function, which passes on each line that it is asked, and the answer.
It inherits two pipes from this process, by way of ikbench (IKBENCH_RELAY). A line in them begins with the name of the relay's
start, so that what comes late for a relay that was ended is not taken for the answer to another. A relay waits for each
answer before it reads on, and ikbench asks one relay at a time."""
import os
import sys


def _relay(number):
    """Passes lines between ikbench and the process that has the function."""
    if "IKBENCH_RELAY" not in os.environ:
        sys.exit("this solver is a function of a Python process that has ended; call ikbench.study there again")
    start = os.urandom(8).hex().encode()
    asked, answers = os.fdopen(4, "wb"), os.fdopen(3, "rb")

    def answered(text):
        asked.write(start + b" " + text)
        asked.flush()
        for line in answers:
            name, _, answer = line.partition(b" ")
            if name == start and answer.startswith(b"!"):
                sys.exit(answer[1:].decode().strip())  # the function raised this
            if name == start:
                return answer
        sys.exit("the process that has the function ended")

    sys.stdout.buffer.write(answered(b"%d\n" % number))
    sys.stdout.flush()
    for line in sys.stdin.buffer:
        sys.stdout.buffer.write(answered(line).lstrip())
        sys.stdout.flush()


if __name__ == "__main__":
    _relay(int(sys.argv[1]))
    sys.exit()

import contextlib
import fcntl
import functools
import html
import json
import pathlib
import queue
import re
import shutil
import signal
import subprocess
import tempfile
import threading
import time
import traceback
import weakref

import ikbench


class _Abandoned(BaseException):
    """Ends a function that asked for evaluations and whose relay was ended meanwhile."""


class _Functions:
    """Calls functions, in a thread of their own, because one that does not return must not keep the caller waiting."""

    def __init__(self, functions, answers):
        self._functions, self._answers, self._lock = functions, answers, threading.Lock()
        self._lines, self._shown, self.is_called = queue.SimpleQueue(), set(), False
        # A call of study() solves all targets of a function again: what the function uses may have changed.
        self._version = f"{time.strftime('%Y-%m-%d %H:%M:%S')} {os.urandom(4).hex()}"
        self._process = os.getpid()
        threading.Thread(target=self._work, daemon=True).start()

    def take(self, line):
        """Takes a line of a relay. Raises TimeoutError if a function still runs, so that ikbench waits no more for it."""
        if self.is_called:
            raise TimeoutError
        start, _, text = line.decode().partition(" ")
        self._lines.put((start, text))

    def close(self):
        """Says no more to relays; a function that still runs says nothing either."""
        self._lines.put(None)
        with self._lock, contextlib.suppress(BrokenPipeError):
            self._answers.close()

    def _say(self, start, text):
        with self._lock, contextlib.suppress(BrokenPipeError):
            if not self._answers.closed:
                self._answers.write(f"{start} {text}\n".encode())
                self._answers.flush()

    def _work(self):
        begun = {}  # solvers by their relay's start
        for start, text in iter(self._lines.get, None):
            with contextlib.suppress(_Abandoned):
                answer = self._answer(start, text, begun)
                if os.getpid() != self._process:  # the function forked, and this is its child
                    os._exit(0)
                self._say(start, answer)

    def _answer(self, start, text, begun):
        if not text.startswith("{"):
            label, function = self._functions[int(text)]
            begun[start] = ikbench._Solver(label, lambda robot: robot, function, version=self._version)
            return json.dumps(begun[start].hello)
        solver = begun[start]

        def ask(message):
            self.is_called = False
            self._say(start, json.dumps(message))
            line = self._lines.get()
            if line is None or line[0] != start:
                self._lines.put(line)
                raise _Abandoned
            self.is_called = True
            return json.loads(line[1])

        self.is_called = True
        try:
            answer = solver.answer(json.loads(text), ask)
            return "" if answer is None else json.dumps(answer)
        except _Abandoned:
            raise
        except BaseException as error:  # a program would end with this
            self._show(solver.hello["name"], error)
            return "!" + ikbench._plain(traceback.format_exception_only(type(error), error)[-1].strip())
        finally:
            self.is_called = False

    def _show(self, label, error):
        """Shows the first exception of each function."""
        if label not in self._shown:
            self._shown.add(label)
            lines = traceback.format_exception(type(error), error, error.__traceback__)
            print(f"ikbench: {label} raised this, and its further targets follow:", "".join(lines), sep="\n", file=sys.stderr)


def _toml(value):
    """The value as TOML writes it, on one line."""
    if hasattr(value, "tolist"):  # of numpy
        value = value.tolist()
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_toml(str(key))} = {_toml(each)}" for key, each in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_toml, value)) + "]"
    raise TypeError(f"{ikbench._plain(repr(value))} is no value of a study; expected a text, a number, a list or a dict")


def _with_places(value):
    """The value with the full names of files that it names, because the study is in another folder."""
    if isinstance(value, dict):
        return {key: _with_places(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return list(map(_with_places, value))
    is_file = isinstance(value, (str, os.PathLike)) and "." in os.fspath(value) and os.path.isfile(value)
    return os.path.abspath(value) if is_file else value


def _entry(label, solver, number, timeout):
    if callable(solver):
        limit = {"timeout_s": timeout} if timeout else {}
        return {"label": label, "process": [sys.executable, os.path.abspath(__file__), str(number)], **limit}
    if isinstance(solver, str):
        return {"label": label, "solver": solver}
    if isinstance(solver, dict):
        return {"label": label, **solver}
    raise TypeError(f"{label} is {ikbench._plain(repr(solver))}; expected a function, the name of a solver, or a dict")


def _study(solvers, timeout, keys):
    """The study file, and its functions by number, with their labels."""
    if not isinstance(solvers, dict) or not solvers or not all(isinstance(label, str) for label in solvers):
        raise TypeError('expected solvers by their labels, such as {"mine": mine, "LM": "levenberg_marquardt"}')
    if "jobs" in keys or "solvers" in keys:
        raise TypeError("jobs and solvers are no keys of this study: it calls one function at a time")
    if any(callable(solver) for solver in solvers.values()) and not sys.executable:
        raise RuntimeError("sys.executable names no Python, which relays need")
    functions = [(label, None if not callable(solver) else _called(solver)) for label, solver in solvers.items()]
    entries = [_entry(label, solver, number, timeout) for number, (label, solver) in enumerate(solvers.items())]
    keys = _with_places({"name": "notebook", **keys, "solvers": entries})
    return "".join(f"{_toml(key)} = {_toml(value)}\n" for key, value in keys.items()), functions


def _called(function):
    def solve(robot, problem):
        problem.robot = robot
        return function(problem)
    return solve


class Result:
    """What a study found. In a notebook it is a table; print() shows what `ikbench run` does."""

    def __init__(self, folder, screen):
        self.folder, self._screen = folder, screen
        self._results = json.loads(pathlib.Path(folder, "results.json").read_text())
        page = pathlib.Path(folder, "report.html").read_text()  # where every text is escaped
        table = re.search(r'<table>.*?</table>(\s*</div>)?(\s*<p class="note">[^\n]*</p>)*', page, re.DOTALL)
        self._table = re.sub("</div>", "", table[0]) if table else ""

    @property
    def headline(self):
        return self._results["headline"]

    @functools.cached_property
    def solves(self):
        """Each solve, a DataFrame."""
        return ikbench.solves(self.folder)

    @functools.cached_property
    def pairs(self):
        """Each comparison of two solvers in a metric, a DataFrame."""
        return ikbench.results(self.folder)

    def __repr__(self):
        return self._screen

    def _repr_html_(self):
        return f"<div><p><b>{html.escape(self.headline)}</b></p>{self._table}</div>"


def _pipe():
    """The ends of a pipe, with numbers above those that a relay has them by."""
    ends = []
    for low in os.pipe():
        ends.append(fcntl.fcntl(low, fcntl.F_DUPFD_CLOEXEC, 10))
        os.close(low)
    return ends


def _end(process, called):
    """Ends ikbench as Ctrl-C does: what it stored is kept, and a solve that waits for a relay leaves no row."""
    if process.poll() is None:
        process.send_signal(signal.SIGINT)
    called.close()  # ends relays
    try:
        process.wait(20)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _run(command, functions, streams):
    """Runs ikbench and answers its relays. Returns its exit code."""
    (theirs_in, ours_out), (ours_in, theirs_out) = _pipe(), _pipe()
    environment = {**os.environ, "IKBENCH_RELAY": f"{theirs_in} {theirs_out}"}
    with os.fdopen(ours_in, "rb") as asked:
        called = _Functions(functions, os.fdopen(ours_out, "wb"))
        try:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=streams[0], stderr=streams[1], env=environment,
                                       pass_fds=(theirs_in, theirs_out), start_new_session=True)
        except BaseException:
            called.close()
            raise
        finally:
            os.close(theirs_in)
            os.close(theirs_out)
        try:
            for line in asked:
                called.take(line)
            code = process.wait()
            if called.is_called:
                raise TimeoutError
            return code
        finally:
            _end(process, called)


def study(solvers, out, timeout, keys):
    """See ikbench.study."""
    text, functions = _study(solvers, timeout, keys)
    work = pathlib.Path(tempfile.mkdtemp(prefix="ikbench-"))
    folder = os.path.abspath(out or work / "out")
    (work / "notebook.toml").write_text(text, encoding="utf-8")
    screen, errors = work / "screen", work / "errors"
    try:
        with open(screen, "wb") as printed, open(errors, "wb") as complained:
            code = _run([ikbench._program(), "run", work / "notebook.toml", "--out", folder, "--figures", "none"], functions,
                        (printed, complained))
        complaint = errors.read_text(encoding="utf-8", errors="replace")
        if code in (1, 2) or code < 0:
            text = re.sub(r"ikbench: (\S*notebook\.toml:\d+:\d+: )?", "", complaint).replace("\n  ", " ").strip()
            raise (ValueError if code == 1 else RuntimeError)(text or f"ikbench ended with the code {code}")
        result = Result(folder, complaint + screen.read_text(encoding="utf-8", errors="replace"))
    except (TimeoutError, KeyboardInterrupt) as stopped:  # what is stored is kept
        if out:
            shutil.rmtree(work, ignore_errors=True)
        why = "a function did not return within its timeout; " if isinstance(stopped, TimeoutError) else ""
        raise type(stopped)(f"{why}what was solved before is in {folder}") from None
    except BaseException:
        shutil.rmtree(work, ignore_errors=True)
        raise
    weakref.finalize(result, shutil.rmtree, work, ignore_errors=True)
    return result
