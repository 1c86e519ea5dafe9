"""The text of an answers file, as `check` keeps it: each question as a comment above its answer."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence

from course.content import Choice, Question

Texts = Sequence[str]
_ODD = re.compile("[\x7f-\x9f\u2028\u2029\ufeff\ufffe\uffff]")
_PLAIN = re.compile(r"[A-Za-z0-9_/][A-Za-z0-9_/ .,+()'-]*")


def answers_text(exercise: str, questions: Iterable[Question], given: Mapping[str, Texts]) -> str:
    """A file that `read_answers` reads back. Answers to unknown questions are kept at its end."""
    asked = list(questions)
    parts = [f"# Your answers to {exercise}. `ros2course check {exercise}` asks and judges them.\n"]
    parts += [_entry(question, given.get(question.id, ())) for question in asked]
    others = given.keys() - {question.id for question in asked}
    if others:
        lines = (f"{_scalar(name)}: {_value(given[name])}\n" for name in sorted(others))
        parts.append("# There are no such questions:\n" + "".join(lines))
    return "\n".join(parts)


def _entry(question: Question, texts: Texts) -> str:
    lines = [*question.ask.splitlines(), *(f"  - {_described(choice)}" for choice in question.choices)]
    comment = "".join(f"# {line}".rstrip() + "\n" for line in lines)
    return f"{comment}{question.id}: {_value(texts)}".rstrip() + "\n"


def _described(choice: Choice) -> str:
    return choice.text if choice.name == choice.text else f"{choice.name}: {choice.text}"


def _value(texts: Texts) -> str:
    if len(texts) == 1:
        return _scalar(texts[0])
    return f"[{', '.join(_quoted(text) for text in texts)}]" if texts else ""


def _scalar(text: str) -> str:
    return text if _PLAIN.fullmatch(text) and text == text.strip() else _quoted(text)


def _quoted(text: str) -> str:
    """JSON's strings are YAML's double-quoted ones, but for what YAML takes for a line end or refuses."""
    return _ODD.sub(lambda odd: f"\\u{ord(odd[0]):04x}", json.dumps(text, ensure_ascii=False))
