"""What is said of a submission that could not be taken as it is: data, safe for any terminal."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

from course.home.opening.names import visible

_NAMED = 3


@dataclass(frozen=True)
class Finding:
    """what: one sentence. advice: the next step. where: the files it is about, at most three by name."""

    what: str
    advice: str | None = None
    where: str | None = None


class Refused(Exception):
    """A submission, or an archive, that is not taken at all."""

    def __init__(self, what: str, advice: str | None = None, where: str | None = None) -> None:
        super().__init__(what)
        self.finding = Finding(what, advice, where)


class Notes:
    """Collects what was left out or changed: one finding for each reason, however many files it is about."""

    def __init__(self) -> None:
        self._count: Counter[tuple[str, str | None]] = Counter()
        self._names: dict[tuple[str, str | None], list[str]] = {}

    def add(self, what: str, name: str, advice: str | None = None) -> None:
        names = self._names.setdefault((what, advice), [])
        self._count[what, advice] += 1
        if len(names) < _NAMED:
            names.append(visible(name))

    def findings(self) -> tuple[Finding, ...]:
        return tuple(Finding(*reason, self._where(reason)) for reason in self._names)

    def _where(self, reason: tuple[str, str | None]) -> str:
        more = self._count[reason] - len(self._names[reason])
        return ", ".join(self._names[reason]) + (f" and {more} more" if more else "")
