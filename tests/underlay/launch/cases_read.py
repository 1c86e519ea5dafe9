"""Launch files as they are written for the real launch, each with what is to come of it.

`cases/<name>_launch.*` is the file, `cases/<name>.yaml` a list of ways to run it:

    words, env        what is given to it
    code              the exit code, 0 unless said
    log               what LogInfo says, in this order (logged_in_any_order: in any)
    of                process: what it writes; for `tell` its arguments (of_in_any_order: in any)
    parameters        process: the parameters that files give it
    said              parts of lines that are there
    order             parts of lines that come in this order
    count             part of a line: how many there are
    slow              true: it takes more than two seconds

<here> is the folder of the file. <share> and <prefix> are those of the package `telling`. <file> stands for
a temporary file, <unique> for a number that no other run has.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from tests.underlay.launch.machine import Answer, Launcher

CASES = Path(__file__).with_name("cases")


@dataclass(frozen=True)
class Case:
    """One way to run a file."""

    file: Path
    number: int
    told: Mapping[str, Any]

    @property
    def label(self) -> str:
        return f"{self.file.name}-{self.number}"


def cases() -> list[Case]:
    files = sorted(CASES.glob("*_launch.*"))
    return [Case(file, number, told) for file in files for number, told in enumerate(_told(file))]


def _told(file: Path) -> list[Mapping[str, Any]]:
    text = (CASES / f"{file.name.rpartition('_launch.')[0]}.yaml").read_text(encoding="utf-8")
    told: list[Mapping[str, Any]] = yaml.safe_load(text)
    return told


def check(case: Case, launcher: Launcher) -> None:
    told = _with_paths(dict(case.told), launcher)
    answer = launcher(case.file, *told.get("words", ()), **told.get("env", {}))
    assert (answer.code, answer.stderr) == (told.get("code", 0), ""), answer
    if "log" in told:
        assert answer.logged == [str(line) for line in told["log"]]
    if "logged_in_any_order" in told:
        assert sorted(answer.logged) == sorted(told["logged_in_any_order"]), answer
    _check_processes(answer, told)
    _check_lines(answer.said, told)


def _check_processes(answer: Answer, told: Mapping[str, Any]) -> None:
    for process, lines in told.get("of", {}).items():
        assert _written(answer, process) == [str(line) for line in lines]
    for process, lines in told.get("of_in_any_order", {}).items():
        assert sorted(_written(answer, process)) == sorted(lines), answer
    for process, parameters in told.get("parameters", {}).items():
        assert _parameters(answer, process) == parameters


def _check_lines(said: list[str], told: Mapping[str, Any]) -> None:
    for part in told.get("said", ()):
        assert any(part in line for line in said), (part, said)
    for part, count in told.get("count", {}).items():
        assert sum(part in line for line in said) == count, (part, said)
    rest = iter(said)
    for part in told.get("order", ()):
        assert any(part in line for line in rest), (part, said)


def _written(answer: Answer, process: str) -> list[str]:
    lines = answer.of(process)
    if not process.startswith("tell-"):
        return lines
    words = [line.removeprefix("arg ") for line in lines if line.startswith("arg ")]
    return ["<file>" if "launch_params_" in word else word for word in words]


def _parameters(answer: Answer, process: str) -> dict[str, Any]:
    """The parameters of all temporary files, without those of the package's own file."""
    merged: dict[str, Any] = {}
    for text in _files(answer, process):
        tree = yaml.safe_load(text)
        for node, values in tree.items() if "shared" not in text else ():
            below = merged.setdefault(node, {}).setdefault("ros__parameters", {})
            below.update(values["ros__parameters"])
    return merged


def _files(answer: Answer, process: str) -> list[str]:
    """The text of each parameter file: `tell` begins each with its own line."""
    lines = [line for line in answer.of(process) if line.startswith(("file ", "begin "))]
    texts: list[str] = []
    for line in lines:
        if line.startswith("begin "):
            texts.append("")
        else:
            texts[-1] += line.removeprefix("file ") + "\n"
    return texts


def _with_paths(told: Any, launcher: Launcher) -> Any:
    if isinstance(told, dict):
        return {_with_paths(key, launcher): _with_paths(value, launcher) for key, value in told.items()}
    if isinstance(told, list):
        return [_with_paths(item, launcher) for item in told]
    if not isinstance(told, str):
        return told
    prefix = launcher.workspace / "install/telling"
    places = {
        "<here>": CASES,
        "<prefix>": prefix,
        "<share>": prefix / "share/telling",
        "<unique>": os.getpid(),
    }
    for placeholder, path in places.items():
        told = told.replace(placeholder, str(path))
    return told
