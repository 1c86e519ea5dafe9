"""Takes results back to an LMS: fills in one column of an exported sheet, and packs letters for upload."""

from __future__ import annotations

import codecs
import io
import json
import re
import zipfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from course.errors import UsageError
from course.report.console import number
from course.report.gradebook.sheets import EXCUSED, tidy

_DELIMITERS = (",", ";", "\t")
# `Homework 1 (99)` in Canvas; `Homework 1 [Total Pts: 10 Score] |99` in Blackboard. Blackboard's columns for
# sums, `[Total Pts: up to 1,499 Score]`, and for words, `[Total Pts: 0 Text]`, are not filled in.
_CANVAS_COLUMN = re.compile(r".*\((?P<id>\d+)\)\s*", re.DOTALL)
_BLACKBOARD_COLUMN = re.compile(
    r".*\[(?!.*(?:\bup to\b|\bText\]))[^\d\]]*(?P<max>\d[\d.,]*)[^\]]*\]\s*\|\s*(?P<id>\d+)\s*", re.DOTALL
)
_OTHER_IDS = frozenset("emailaddress email idnumber sisuserid sisloginid studentid username".split())
_POINTS_POSSIBLE = "Points Possible"
_READ_ONLY = "(read only)"
_FORM = (
    "It must be as the LMS exported it: Canvas's gradebook, Moodle's grading worksheet, Blackboard's columns."
)


@dataclass(frozen=True)
class Cell:
    """start, end: where it is in the file's text, quotes included. value: its content, without quotes."""

    start: int
    end: int
    value: str


@dataclass(frozen=True)
class Score:
    """A person's points, None if there are none to give, and why: see `Sheet.state`."""

    points: float | None
    state: str


@dataclass(frozen=True)
class Filled:
    """content: the new file. lms, column: what was filled in. filled: how many cells were filled in.

    changed: how many of these had another content. left: ids in the sheet whose cell is unchanged, and why.
    absent: people of the class whom the sheet does not list.
    """

    content: bytes
    lms: str
    column: str
    filled: int
    changed: int
    left: tuple[tuple[str, str], ...]
    absent: tuple[str, ...]


@dataclass(frozen=True)
class _Form:
    """How an LMS writes its sheet. key: column of the ids. target: column of the grades.

    first: the first row of a person. most: the sheet's maximum as a text; "" if it does not say.
    """

    lms: str
    key: int
    target: int
    first: int = 1
    most: str = ""
    locked: int | None = None


def fill(
    content: bytes,
    scores: Mapping[str, Score],
    most: float,
    id_of: Callable[[str], str],
    column: str = "",
    scale: bool | None = None,
) -> Filled:
    """content: the sheet. scores: by id. most: the class's maximum. id_of: from a cell to a person's id.

    column: name or id of the column, if there are several. scale: whether to convert points to the sheet's
    maximum; None refuses if the maximums differ. Raises UsageError.
    """
    text, encoding = _decoded(content)
    rows, form = _read(text, column)
    factor, comma = _factor(form.most, most, scale)
    return _Filling(text, encoding, rows, form, factor, comma).filled(scores, id_of)


def moodle_feedback(letters: Iterable[tuple[str, str, str]]) -> bytes:
    """A zip for Moodle's *Upload multiple feedback files in a zip*. letters: number, name and letter of each.

    Moodle reads the participant's number and the plugin from the parts of a file's name between underscores.
    """
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for participant, name, letter in letters:
            shown = re.sub(r"[\W_]+", " ", name).strip() or "Participant"
            archive.writestr(f"{shown}_{participant}_assignfeedback_file_feedback.md", letter)
    return stream.getvalue()


def canvas_comments(letters: Iterable[tuple[str, str, str]]) -> str:
    """The body for Canvas' `update_grades`, as JSON: a comment for each user, and no grade."""
    data = {user: {"text_comment": letter} for user, _, letter in letters}
    return json.dumps({"grade_data": data}, ensure_ascii=False, indent=1)


class _Filling:
    def __init__(
        self, text: str, encoding: str, rows: list[list[Cell]], form: _Form, factor: float, comma: bool
    ) -> None:
        self._text = text
        self._encoding = encoding
        self._rows = rows
        self._form = form
        self._factor = factor
        self._comma = comma
        self._left: list[tuple[str, str]] = []

    def filled(self, scores: Mapping[str, Score], id_of: Callable[[str], str]) -> Filled:
        form = self._form
        key = self._key(scores, id_of)
        edits: list[tuple[Cell, str]] = []
        seen = set()
        for row in self._rows[form.first :]:
            who = id_of(row[key].value) if len(row) > max(key, form.target) else ""
            seen.add(who)
            value = self._value(who, row, scores.get(who)) if who else None
            if value is not None:
                edits.append((row[form.target], value))
        changed = sum(cell.value.strip() not in ("", value) for cell, value in edits)
        return Filled(
            _edited(self._text, edits).encode(self._encoding, "surrogateescape"),
            form.lms,
            self._rows[0][form.target].value.strip(),
            len(edits),
            changed,
            tuple(self._left),
            tuple(who for who in scores if who not in seen),
        )

    def _key(self, scores: Mapping[str, Score], id_of: Callable[[str], str]) -> int:
        """The column of the LMS's own ids, or of other ids that the class uses, such as email addresses."""
        others = (at for at, cell in enumerate(self._rows[0]) if _letters(cell.value) in _OTHER_IDS)
        for at in (self._form.key, *others):
            if any(id_of(row[at].value) in scores for row in self._rows[self._form.first :] if len(row) > at):
                return at
        return self._form.key

    def _value(self, who: str, row: Sequence[Cell], score: Score | None) -> str | None:
        form = self._form
        if form.locked is not None and row[form.locked].value.strip().lower() == "no":
            self._left.append((who, "the sheet says that the grade cannot be changed"))
        elif score is None:
            self._left.append((who, "not in the class"))
        elif score.state == EXCUSED and form.lms == "Canvas":
            return "EX"
        elif score.points is None:
            self._left.append((who, score.state))
        else:
            value = number(tidy(round(score.points * self._factor, 2)))
            return value.replace(".", ",") if self._comma else value
        return None


def _factor(given: str, most: float, scale: bool | None) -> tuple[float, bool]:
    """The factor for points, and whether the sheet uses a decimal comma."""
    given = re.sub(r",(?=\d{3}\b)", "", given)  # thousands separators
    comma = "," in given
    try:
        theirs = float(given.replace(",", ".")) if given else most
    except ValueError:
        theirs = most
    if scale is None and theirs != most:
        what = f"The sheet is out of {number(theirs)} points, and this class is out of {number(most)}."
        raise UsageError(what, "Add --scale to convert the points, or --no-scale to write them as they are.")
    return (theirs / most if scale and most else 1.0), comma


def _decoded(content: bytes) -> tuple[str, str]:
    """The text, with its byte order mark, and its encoding."""
    for mark, encoding in ((codecs.BOM_UTF16_LE, "utf-16-le"), (codecs.BOM_UTF16_BE, "utf-16-be")):
        if content.startswith(mark):
            try:
                return content.decode(encoding), encoding
            except UnicodeDecodeError:
                raise UsageError("The sheet is damaged: not all of it is UTF-16.", _FORM) from None
    return content.decode("utf-8", "surrogateescape"), "utf-8"


def _read(text: str, column: str) -> tuple[list[list[Cell]], _Form]:
    for delimiter in _DELIMITERS:
        rows = list(_rows(text, delimiter))
        head = [_letters(cell.value) for cell in rows[0]] if rows else []
        if {"student", "id"} <= set(head):
            return rows, _canvas(rows, head, column)
        if {"identifier", "grade"} <= set(head):
            return rows, _moodle(rows, head)
        if "username" in head and len(head) > 1:
            return rows, _blackboard(rows, head, column)
    raise UsageError("This is not a sheet of Canvas, Moodle, or Blackboard.", _FORM)


def _letters(head: str) -> str:
    return re.sub(r"[\s_\ufeff]+", "", head).lower()


def _canvas(rows: list[list[Cell]], head: list[str], column: str) -> _Form:
    special = next((at for at, row in enumerate(rows[1:4], 1) if _is_possible(row)), None)
    possible = [cell.value.strip() for cell in rows[special]] if special is not None else []
    shown = {at: cell.value for at, cell in enumerate(rows[0])}
    ids = {at: found["id"] for at, name in shown.items() if (found := _CANVAS_COLUMN.fullmatch(name))}
    writable = {at: one for at, one in ids.items() if _READ_ONLY not in possible[at : at + 1]}
    target = _chosen({at: (shown[at], one) for at, one in writable.items()}, column)
    most = possible[target] if target < len(possible) else ""
    return _Form("Canvas", head.index("id"), target, (special or 0) + 1, most)


def _is_possible(row: Sequence[Cell]) -> bool:
    return row[0].value.strip() == _POINTS_POSSIBLE


def _moodle(rows: list[list[Cell]], head: list[str]) -> _Form:
    maximum = head.index("maximumgrade") if "maximumgrade" in head else None
    given = [row[maximum].value.strip() for row in rows[1:2]] if maximum is not None else []
    locked = head.index("gradecanbechanged") if "gradecanbechanged" in head else None
    return _Form("Moodle", head.index("identifier"), head.index("grade"), 1, "".join(given), locked)


def _blackboard(rows: list[list[Cell]], head: list[str], column: str) -> _Form:
    found = {at: _BLACKBOARD_COLUMN.fullmatch(cell.value) for at, cell in enumerate(rows[0])}
    known = {at: (rows[0][at].value, match["id"]) for at, match in found.items() if match}
    target = _chosen(known, column)
    match = found[target]
    return _Form("Blackboard", head.index("username"), target, 1, match["max"] if match else "")


def _chosen(columns: Mapping[int, tuple[str, str]], wanted: str) -> int:
    plain = " ".join(wanted.split())
    names = {at: " ".join(name.split()) for at, (name, _) in columns.items()}
    fits = [at for at, (_, one) in columns.items() if plain in ("", one) or names[at].startswith(plain)]
    exact = [at for at in fits if plain in (names[at], columns[at][1])] or fits
    if len(exact) == 1:
        return exact[0]
    listed = ", ".join(names[at] for at in (exact or columns)) or "none"
    what = "Several columns of the sheet match." if exact else "No column of the sheet matches."
    raise UsageError(what, f"Name one with --column, by its name or id: {listed}")


def _rows(text: str, delimiter: str) -> Iterator[list[Cell]]:
    at, row = (1 if text.startswith("\ufeff") else 0), list[Cell]()
    while at <= len(text):
        cell = _cell(text, at, delimiter)
        row.append(cell)
        at = cell.end + 1
        if text[cell.end : cell.end + 1] != delimiter:
            at += text[cell.end : cell.end + 2] == "\r\n"
            if len(row) > 1 or row[0].value:
                yield row
            row = []


def _cell(text: str, start: int, delimiter: str) -> Cell:
    if text[start : start + 1] != '"':
        ended = re.compile(rf"[{delimiter}\r\n]").search(text, start)
        end = ended.start() if ended else len(text)
        return Cell(start, end, text[start:end])
    closing = re.compile(r'"(?:[^"]|"")*"').match(text, start)
    if closing is None:
        raise UsageError("The sheet is damaged: a quoted cell is not closed.", _FORM)
    ended = re.compile(rf"[{delimiter}\r\n]").search(text, closing.end())
    end = ended.start() if ended else len(text)
    return Cell(start, end, closing[0][1:-1].replace('""', '"'))


def _edited(text: str, edits: Iterable[tuple[Cell, str]]) -> str:
    """Change these cells. A quoted cell stays quoted."""
    pieces, at = [], 0
    for cell, value in edits:
        quoted = text[cell.start : cell.start + 1] == '"' or "," in value
        pieces += [text[at : cell.start], f'"{value}"' if quoted else value]
        at = cell.end
    return "".join((*pieces, text[at:]))
