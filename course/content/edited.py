"""A solution as the edits of a mistake leave it, one after the other, without writing anything."""

from __future__ import annotations

from pathlib import Path

from course.content.additions import ADDED_TO
from course.content.model import Edit


class Edited:
    """The files of `solution` and of those before it; `apply` changes what `text` tells of them."""

    def __init__(self, solution: Path) -> None:
        self.solution = solution
        self._changed: dict[str, str | None] = {}

    def text(self, file: str) -> str | None:
        """None where there is no such file, or not any more."""
        if file in self._changed:
            return self._changed[file]
        own = _read(self.solution / file)
        if own is not None and file not in ADDED_TO:
            return own
        # A trial holds what the exercises before have made, too: any earlier chapter's, without asking which.
        others = sorted(self.solution.parent.glob("*/"), reverse=True)
        earlier = [_read(other / file) for other in others if other.name < self.solution.name]
        found = [text for text in (own, *earlier) if text is not None]
        if file in ADDED_TO:
            return "\n".join(found) if found else None
        return found[0] if found else None

    def apply(self, edit: Edit) -> None:
        """An edit that does not fit changes nothing."""
        text = self.text(edit.file)
        if edit.content is not None:
            self._changed[edit.file] = edit.content
        elif text is not None and (edit.delete or edit.rename is not None):
            self._changed[edit.file] = None
            if edit.rename is not None:
                self._changed[edit.rename] = text
        elif text is not None and edit.replace is not None:
            self._changed[edit.file] = text.replace(edit.replace, edit.with_ or "")


def _read(file: Path) -> str | None:
    try:
        return file.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return None
