"""The lines between `watch` and the process that checks: a task down, what is said of it up."""

from __future__ import annotations

import json
from dataclasses import asdict

from course.grading.result import from_json, to_json
from course.watch.model import Checked, Message, Said, Stuck, Task


def task_to_line(task: Task) -> str:
    return json.dumps(asdict(task))


def task_from_line(line: str) -> Task:
    return Task(**json.loads(line))


def message_to_line(message: Message) -> str:
    if isinstance(message, Checked):
        return json.dumps({"kind": "checked", "number": message.number, "result": to_json(message.result)})
    return json.dumps({"kind": "said" if isinstance(message, Said) else "stuck", **asdict(message)})


def message_from_line(line: str) -> Message:
    """Raises ValueError, KeyError or TypeError on anything else."""
    data = json.loads(line)
    kind = data.pop("kind")
    if kind == "checked":
        return Checked(data["number"], from_json(data["result"]))
    return Said(**data) if kind == "said" else Stuck(**data)
