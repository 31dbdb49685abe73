"""Reads what ikbench writes: solves, means of runs, findings.

    import ikbench
    store = ikbench.Store("out/slim2023/store.sqlite")
    store.studies                          # ["slim2023", ...]
    store.solves("slim2023")               # a row for each solve
    store.run_means("slim2023", "position_error_cm")
    ikbench.findings("out/slim2023")       # a row for each pair of solvers and each quantity

Rows are dictionaries in a list. `.frame()` of a list makes a pandas.DataFrame where pandas is installed. Nothing is
written: the store is opened to read. What cannot be read raises ikbench.Error, with one sentence.

docs/data-dictionary.md explains the columns.
"""

import contextlib
import json
import math
import pathlib
import sqlite3
import statistics

__version__ = "1.0.0"

_APPLICATION_ID = 0x494B424E  # "IKBN"
_SCHEMA = 23
_LISTS = (
    "target_position_m",
    "target_rotation",
    "start_rad",
    "answer_rad",
    "reached_position_m",
    "trace_cm",
    "improved_at",
    "improved_to_cm",
)
_TIMES = ("seconds", "cpu_seconds", "claimed_seconds")
_TYPES = {"REAL": (float, type(None)), "INTEGER": int, "TEXT": str}


class Error(ValueError):
    """A file that is missing, damaged or of another version, or a name that it does not have."""


@contextlib.contextmanager
def _reading(path):
    """Raises Error where the file does not have what ikbench wrote."""
    try:
        yield
    except Error:
        raise
    except (sqlite3.Error, ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
        raise Error(f"{path}: it is damaged ({error}); restore a copy, or make it again") from error
    except OSError as error:
        raise Error(f"{path}: {error.strerror}") from error


def _numbers(text):
    numbers = json.loads(text)
    if not all(number is None or isinstance(number, (int, float)) for number in numbers):
        raise ValueError("a list has something else than numbers")
    return [math.nan if number is None else number for number in numbers]


class Rows(list):
    """A list of dictionaries with the same keys."""

    def frame(self):
        """Returns a pandas.DataFrame; raises ImportError where pandas is not installed."""
        import pandas

        return pandas.DataFrame(self)


class Store:
    """A store, opened to read. Raises Error if the file is no store of this version."""

    def __init__(self, path):
        path = pathlib.Path(path)
        if path.is_dir():
            path = path / "store.sqlite"
        if not path.is_file():
            raise Error(f"{path}: there is no such file")
        self._path = path
        self._database = sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", uri=True)
        self._database.row_factory = sqlite3.Row
        self._database.text_factory = lambda text: text.decode("utf-8", "replace")
        try:
            application, schema = (
                self._database.execute(f"PRAGMA {name}").fetchone()[0] for name in ("application_id", "user_version")
            )
        except sqlite3.DatabaseError as error:
            raise Error(f"{path}: {error}; expected a store that ikbench wrote") from error
        if application != _APPLICATION_ID:
            raise Error(f"{path}: this is a database of another program; expected a store that ikbench wrote")
        if schema != _SCHEMA:
            raise Error(f"{path}: the store has schema {schema}; this file reads schema {_SCHEMA}")

    def close(self):
        self._database.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    @property
    def studies(self):
        """The names of the studies, in their order."""
        with _reading(self._path):
            return [row["name"] for row in self._database.execute("SELECT name FROM studies ORDER BY position")]

    def definition(self, study=None):
        """The definition of a study, a dictionary: robot, path, stop rule, analysis plan, ..."""
        study = self._known(study)
        query = "SELECT definition FROM studies WHERE name = ?"
        with _reading(self._path):
            return dict(json.loads(self._database.execute(query, (study,)).fetchone()[0]))

    def solves(self, study=None):
        """The current solves of a study (by default of the only one), in the order solver, run, point.

        Lists are lists of numbers. A number that is not known is NaN. `evaluations` that nobody counted are None.
        """
        study = self._known(study)
        rows = Rows()
        query = """SELECT solves.* FROM studies JOIN series ON series.study = studies.name
                   JOIN solves ON solves.series = series.key
                   WHERE studies.name = ? AND run <= json_extract(definition, '$.runs')
                   ORDER BY series.position, run, point"""
        with _reading(self._path):
            cursor = self._database.execute(query, (study,))
            types = {row["name"]: row["type"] for row in self._database.execute("PRAGMA table_info(solves)")}
            for found in cursor:
                row = dict(found)
                for name, value in row.items():
                    if not isinstance(value, _TYPES[types[name]]):
                        raise ValueError(f"{name} is {value!r}")
                    if name in _LISTS:
                        row[name] = _numbers(value)
                    elif value is None:
                        row[name] = math.nan
                row["study"] = study
                if row["counted_by"] == "nobody":
                    row["evaluations"] = None
                rows.append(row)
        return rows

    def run_means(self, study=None, column="position_error_cm"):
        """One observation for each solver and run: the mean over its points, of times the median."""
        of_run = {}
        for row in self.solves(study):
            if column not in row or isinstance(row[column], (str, list)):
                raise Error(f"{column!r} is no column of numbers; ikbench list columns names them")
            value = row[column]
            of_run.setdefault((row["solver"], row["run"]), []).append(math.nan if value is None else value)
        middle = statistics.median if column in _TIMES else statistics.fmean
        return Rows(
            {
                "solver": solver,
                "run": run,
                "points": len(values),
                column: math.nan if any(map(math.isnan, values)) else middle(values),
            }
            for (solver, run), values in of_run.items()
        )

    def _known(self, study):
        names = self.studies
        if study is None and len(names) == 1:
            return names[0]
        if study not in names:
            raise Error(f"the store has no study {study!r}; it has {', '.join(map(repr, names))}")
        return study


def findings(report):
    """A row for each quantity and each pair of groups that `ikbench report` or `ikbench stats` judged.

    `report` is the folder of the report, or its statistics.json. An interval is two columns, `..._low` and `..._high`.
    """
    path = pathlib.Path(report)
    if path.is_dir():
        path = path / "statistics.json"
    rows = Rows()
    with _reading(path):
        for judged in json.loads(path.read_text(encoding="utf-8")):
            of_all = {key: judged.get(key) for key in ("quantity", "unit", "better", "method")}
            for contrast in judged.get("contrasts", []):
                row = dict(of_all)
                for key, value in contrast.items():
                    if isinstance(value, dict):
                        row[key] = value.get("value")
                        row[key + "_low"], row[key + "_high"] = value.get("low"), value.get("high")
                    else:
                        row[key] = value
                rows.append(row)
    keys = dict.fromkeys(key for row in rows for key in row)
    return Rows({key: row.get(key) for key in keys} for row in rows)
