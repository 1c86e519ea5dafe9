"""Every type that is sent comes back unchanged, and damage is reported.

The values are made of the types themselves: a new field, or a new type in `TRAVELS`, is tested with no more.
"""

from __future__ import annotations

import json
import random
from datetime import datetime, timezone
from enum import Enum
from pathlib import Path
from typing import Any

import msgspec
import pytest
from msgspec import inspect

import course.validate.proofs as proofs
import course.watch.updates as watch
from course.batch.gradings import Graded, GradingTask, Unit
from course.batch.results import BatchSettings
from course.errors import DamagedData
from course.evidence.home_files import HomeEntry
from course.evidence.packages import BuiltPackages
from course.evidence.sources import Sources
from course.grading.protocol import Judged, Portion, RecordingOutcome, RecordingTask, Stage, Unjudged
from course.model import codec
from course.model.events import AnyEvent, Event
from course.model.feedback import Feedback
from course.model.result import Result
from course.validate.proofs import ProofResult

BY_NAME = (
    *(Feedback, Result, RecordingTask, Portion, BuiltPackages, Sources, HomeEntry),
    *(Unit, Graded, BatchSettings, ProofResult),
)
TRAVELS: dict[str, Any] = {
    **{kind.__name__: kind for kind in Event.__subclasses__()},
    **{kind.__name__: kind for kind in BY_NAME},
    "a line of the recording process": Stage | RecordingOutcome,
    "an answer of a judge": Judged | Unjudged,
    "a task of a batch": GradingTask,
    "a task of a proof": proofs.ProofTask,
    "a task of watch": watch.CheckTask,
    "what watch hears": watch.Message,
}
TEXTS = ("", "one\ntwo", 't\t, "x" \\', "häufig, 日本語 ✓ 🤖", "\x00\x1b[31m\x7f\u2028\ufeff", "caf\udce9")
ROUNDS = 20


def made(kind: inspect.Type, dice: random.Random) -> Any:
    """A random value of this type."""
    match kind:
        case inspect.UnionType(types=types):
            return made(dice.choice(types), dice)
        case inspect.NoneType():
            return None
        case inspect.BoolType():
            return dice.random() < 0.5
        case inspect.IntType():
            return dice.choice((0, 1, -7, 2**53 + 1, 2**62 + 7))
        case inspect.FloatType():
            return dice.choice((0.0, 0.1 + 0.2, 1e-9, -1e300, 12.5))
        case inspect.CustomType(cls=cls):
            assert cls is Path
            return Path(dice.choice(("/tmp/a b", "häufig", "caf\udce9")))
        case inspect.DateTimeType():
            return datetime.fromtimestamp(dice.randrange(2**31), timezone.utc)
        case inspect.BytesType():
            return dice.randbytes(dice.randrange(5))
        case inspect.StrType():
            return dice.choice(TEXTS)
        case inspect.LiteralType(values=values):
            return dice.choice(values)
        case inspect.EnumType(cls=cls):
            return dice.choice(list(cls))
        case inspect.VarTupleType(item_type=item):
            return tuple(made(item, dice) for _ in range(dice.randrange(3)))
        case inspect.TupleType(item_types=items):
            return tuple(made(item, dice) for item in items)
        case inspect.DictType(value_type=value):
            return {text: made(value, dice) for text in TEXTS[: dice.randrange(len(TEXTS))]}
        case inspect.StructType(cls=cls, fields=fields) | inspect.DataclassType(cls=cls, fields=fields):
            return cls(**{field.name: made(field.type, dice) for field in fields})
    raise AssertionError(f"no values of {kind} are made here")


@pytest.mark.parametrize("name", TRAVELS)
def test_all_that_travels_comes_back_as_it_was(name: str) -> None:
    dice = random.Random(name)
    for _ in range(ROUNDS):
        value = made(inspect.type_info(TRAVELS[name]), dice)
        line = codec.to_json(value)
        assert b"\n" not in line
        back = codec.from_json(line, TRAVELS[name], "it")
        assert (back, type(back)) == (value, type(value))
        assert codec.from_json(line.decode(), TRAVELS[name], "it") == value
        json.loads(line, parse_constant=pytest.fail)  # as strict as other readers are


@pytest.mark.parametrize("name", [kind.__name__ for kind in Event.__subclasses__()])
def test_an_event_is_known_by_its_kind(name: str) -> None:
    event = made(inspect.type_info(TRAVELS[name]), random.Random(name))
    line = codec.to_json(event)
    assert json.loads(line)["kind"] == name
    back = codec.from_json(line, AnyEvent, "it")
    assert (back, type(back), hash(back)) == (event, TRAVELS[name], hash(event))


@pytest.mark.parametrize("name", TRAVELS)
def test_damage_is_told_of_with_its_file(name: str) -> None:
    """Each field in turn gets a wrong type."""
    kind = TRAVELS[name]
    data = json.loads(codec.to_json(made(inspect.type_info(kind), random.Random(name))))
    for field in data:
        damaged = json.dumps({**data, field: [{"no": "field is like that"}]})
        with pytest.raises(DamagedData, match=rf"^some/file is damaged: .*\$\.{field}"):
            codec.from_json(damaged, kind, Path("some/file"))


@pytest.mark.parametrize("text", ["", "{", "no json", "5", "null", "[]", "[" * 100_000, '"\\udce9"', b"\xff"])
@pytest.mark.parametrize("kind", [Result, AnyEvent, Stage | RecordingOutcome])
def test_what_is_none_of_it_is_refused(text: str | bytes, kind: Any) -> None:
    with pytest.raises(DamagedData, match=r"^a line is damaged: "):
        codec.from_json(text, kind, "a line")


@pytest.mark.parametrize("half", ["", "\\\\udce9"], ids=["whole", "half a character"])
@pytest.mark.parametrize("number", ["1e999", "-1e999", "Infinity", "-Infinity", "NaN"])
def test_a_number_that_cannot_be_written_is_not_read(number: str, half: str) -> None:
    """It would be written as null, and that could not be read again."""
    line = f'{{"kind": "Observed", "t": {number}, "what": "ran", "error": "{half}"}}'
    with pytest.raises(DamagedData):
        codec.from_json(line, AnyEvent, "a note")


@pytest.mark.parametrize(
    "data", [{"kind": "Unheard", "t": 1.0}, {"kind": "Event", "t": 1.0}, {"kind": "Marked", "t": 1, "x": 1}]
)
def test_an_event_of_another_version_is_refused(data: dict[str, object]) -> None:
    with pytest.raises(DamagedData):
        codec.from_json(json.dumps(data), AnyEvent, "a recording")


def test_no_type_is_without_values() -> None:
    """`made` makes each alternative of a union, and each member of an enum, sooner or later."""

    class Letter(Enum):
        A = "a"
        B = "b"

    kind = inspect.type_info(Letter | None)
    found = {made(kind, random.Random(n)) for n in range(50)}
    assert found == {Letter.A, Letter.B, None}
    assert isinstance(made(inspect.type_info(Result), random.Random(0)), msgspec.Struct)
