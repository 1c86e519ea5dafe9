"""The engine's texts, in full and only once: `golden(value)` compares them with the test's entry in a file.

`tests/explain/test_cmake.py` has its entries in `tests/explain/golden/cmake.txt`. After a change that is
meant, write the entries of whole files again, and read the difference: `GOLDEN=write pytest tests/explain`.
"""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Iterable, Mapping
from difflib import unified_diff
from enum import Enum
from pathlib import Path

import msgspec
import pytest

from course.model.feedback import Location

WRITES = os.environ.get("GOLDEN") == "write"
_HEAD = "== "
_written: dict[Path, dict[str, list[str]]] = {}
_read: dict[Path, dict[str, list[str]]] = {}
_calls: dict[str, int] = {}


def golden(*values: object) -> None:
    """Fail unless the values are as in the file. A test may call it several times."""
    file, test = _current()
    lines = [line for value in values for line in ("--", *shown(value))][1:]
    if WRITES:
        _written.setdefault(file, {})[test] = lines
        _write(file, _written[file])
        return
    expected = entries(file).get(test)
    assert expected is not None, f"{file} has no entry `{test}`; {__doc__}"
    lines = [line.rstrip() for line in lines]
    if lines != expected:
        difference = "\n".join(unified_diff(expected, lines, "golden", "now", lineterm="", n=9))
        pytest.fail(f"{test}:\n{difference}", pytrace=False)


def shown(value: object) -> list[str]:
    """The value as lines; for a struct, the fields that are not empty."""
    if isinstance(value, str | Location):
        return str(value).splitlines() or [""]
    if isinstance(value, Enum | float | int) or value is None:
        return [str(value)]
    if isinstance(value, Mapping):
        return [line for key, one in value.items() for line in _named(str(key), one)]
    if isinstance(value, msgspec.Struct) or dataclasses.is_dataclass(value):
        fields = [one.name for one in _fields(value)]
        return [line for name in fields for line in _named(name, getattr(value, name))]
    assert isinstance(value, Iterable), f"do not know how to show {value!r}"
    return [line for one in value for line in shown(one)]


def _fields(value: object) -> Iterable[dataclasses.Field[object] | msgspec.structs.FieldInfo]:
    kind = type(value)
    return msgspec.structs.fields(kind) if isinstance(value, msgspec.Struct) else dataclasses.fields(value)


def _named(name: str, value: object) -> list[str]:
    if value is None or value == () or value == "":
        return []
    lines = shown(value)
    return [f"{name}: {lines[0]}"] if len(lines) == 1 else [f"{name}:", *(f"  {line}" for line in lines)]


def _current() -> tuple[Path, str]:
    """The golden file of the running test, and the entry's name."""
    current = os.environ["PYTEST_CURRENT_TEST"].rpartition(" (")[0]
    place, _, test = current.partition("::")
    module = Path(__file__).parents[1] / place
    _calls[current] = _calls.get(current, 0) + 1
    number = "" if _calls[current] == 1 else f" {_calls[current]}"
    return module.parent / "golden" / f"{module.stem.removeprefix('test_')}.txt", test + number


def entries(file: Path) -> Mapping[str, list[str]]:
    """The lines of each entry, by its name."""
    if file not in _read:
        _read[file] = {}
        for line in file.read_text(encoding="utf-8").splitlines() if file.exists() else ():
            if line.startswith(_HEAD):
                _read[file][line.removeprefix(_HEAD)] = lines = []
            else:
                lines.append(line.removeprefix("  "))
    return _read[file]


def _write(file: Path, every: Mapping[str, list[str]]) -> None:
    file.parent.mkdir(exist_ok=True)
    parts = (
        _HEAD + name + "\n" + "".join(f"  {line}".rstrip() + "\n" for line in lines)
        for name, lines in every.items()
    )
    file.write_text("".join(parts), encoding="utf-8")
