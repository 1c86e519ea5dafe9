"""Converts data to JSON and back: in files, in databases, and as lines between processes.

It handles structs, dataclasses, enums, paths and unions of tagged structs; msgspec does the work. What is
read has the types that were asked for; anything else raises DamagedData.
"""

from __future__ import annotations

import json
import math
from functools import lru_cache
from pathlib import Path
from typing import Any, TypeVar, overload

import msgspec

from course.errors import DamagedData

T = TypeVar("T")
_HALF = b"\\ud"


def to_json(value: object) -> bytes:
    """One line of JSON, without a line end. JSON has no infinity: it becomes null."""
    try:
        return msgspec.json.encode(value, enc_hook=_path_as_text)
    except UnicodeEncodeError:
        # Half a character, as in a file name that is not UTF-8. JSON can contain it as an escape.
        return json.dumps(msgspec.to_builtins(value, enc_hook=_path_as_text)).encode("ascii")


@overload
def from_json(data: bytes | str, kind: type[T], source: str | Path) -> T: ...
@overload
def from_json(data: bytes | str, kind: Any, source: str | Path) -> Any: ...
def from_json(data: bytes | str, kind: Any, source: str | Path) -> Any:
    """Read a value of the type `kind` that `to_json` wrote. source: where it is from, for error messages.

    Raises DamagedData, which names `source` and the place in it.
    """
    text = data.encode("utf-8", errors="surrogatepass") if isinstance(data, str) else data
    try:
        if _HALF in text:
            value = json.loads(text, parse_constant=_finite, parse_float=_finite)
            return msgspec.convert(value, kind, dec_hook=_path_of_text)
        return _decoder(kind).decode(text)
    except (ValueError, RecursionError) as error:  # msgspec's errors are ValueErrors, and so are json's
        raise DamagedData(f"{source} is damaged: {error}.") from error


def _finite(text: str) -> float:
    if not math.isfinite(number := float(text)):
        raise ValueError(f"{text} is not a number in JSON")
    return number


@lru_cache
def _decoder(kind: Any) -> msgspec.json.Decoder[Any]:
    return msgspec.json.Decoder(kind, dec_hook=_path_of_text)


def _path_as_text(value: object) -> str:
    if isinstance(value, Path):
        return str(value)
    raise TypeError(f"{type(value).__name__} cannot be sent")


def _path_of_text(kind: type[Any], value: Any) -> Path:
    if kind is Path and isinstance(value, str):
        return Path(value)
    raise ValueError(f"Expected `{kind.__name__}`, got {value!r}")
