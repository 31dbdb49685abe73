#!/usr/bin/env python3
"""runner.py ACTION REF [INPUT=VALUE]...: runs the steps of ACTION/action.yml as a forge's runner does, in the current folder.

It reads as much of YAML and of the forge's expressions as action.yml has. Each step has the environment of a runner and no
more; `github.action_ref` is known to expressions only, as there. Writes runner/summary.md; prints the outputs last, and ends
with the exit code of the step that fails."""
import os
import pathlib
import re
import subprocess
import sys

action, ref = pathlib.Path(sys.argv[1]), sys.argv[2]
inputs, outputs, steps, where, name = {}, {}, [], "", ""
for line in (action / "action.yml").read_text().splitlines():
    depth, text = len(line) - len(line.lstrip()), line.strip()
    key, _, value = text.removeprefix("- ").partition(":")
    value = value.strip()
    plain = value[1:-1] if value[:1] == '"' else value
    if depth == 0:
        where = key
    elif where in ("inputs", "outputs") and depth == 2:
        name = key
    elif where == "inputs" and key == "default":
        inputs[name] = plain
    elif where == "outputs" and key == "value":
        outputs[name] = plain
    elif depth == 4 and text.startswith("- "):
        steps.append({"id": value, "env": {}})
    elif steps and depth == 6 and key == "run":
        steps[-1]["run"] = value
    elif steps and depth == 8 and text[0] != "#":
        name = key
        steps[-1]["env"][name] = "" if value == "|" else plain
    elif steps and depth == 10:
        steps[-1]["env"][name] += text + "\n"

for given in sys.argv[3:]:
    name, _, value = given.partition("=")
    if name not in inputs and name != "study":
        sys.exit(f"{name} is no input of {action}/action.yml")
    inputs[name] = value
known = {f"inputs.{name}": value for name, value in inputs.items()}
known |= {"github.action_ref": ref, "github.action_repository": "owner/ikbench"}


def filled(text):
    def value_of(match):
        return known.get(match[1], "") or match[3] or ""
    return re.sub(r"\$\{\{ ([\w.-]+)( \|\| '([^']*)')? \}\}", value_of, text)


here = pathlib.Path("runner").resolve()
(here / "temp").mkdir(parents=True, exist_ok=True)
runner = {
    "PATH": os.environ["PATH"], "HOME": str(here), "CI": "true", "GITHUB_ACTIONS": "true", "GITHUB_ACTION_PATH": str(action),
    "GITHUB_ACTION_REF": "", "GITHUB_ACTION_REPOSITORY": "", "GITHUB_SERVER_URL": "https://github.com",
    "GITHUB_WORKSPACE": os.getcwd(), "GITHUB_STEP_SUMMARY": str(here / "summary.md"), "RUNNER_OS": "Linux",
    "RUNNER_TEMP": str(here / "temp")}
code = 0
for step in steps:
    file = here / "output"
    file.write_text("")
    script = here / "step.sh"
    script.write_text(step["run"])
    environment = runner | {"GITHUB_OUTPUT": str(file)} | {name: filled(value) for name, value in step["env"].items()}
    code = subprocess.run(["bash", "--noprofile", "--norc", "-e", "-o", "pipefail", script], env=environment).returncode
    for line in file.read_text().splitlines():
        name, _, value = line.partition("=")
        known[f"steps.{step['id']}.outputs.{name}"] = value
    if code:
        break
sys.stdout.flush()
print("\n".join(f"{name}={filled(value)}" for name, value in outputs.items()))
sys.exit(code)
