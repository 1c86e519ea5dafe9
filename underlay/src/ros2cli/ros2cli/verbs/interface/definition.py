"""The lines of an interface's definition: what is a comment, and which other type a field has."""

from __future__ import annotations

import re
from dataclasses import dataclass

_PRIMITIVE = re.compile(r"bool|byte|char|float(32|64)|u?int(8|16|32|64)|w?string")
_FIELD = re.compile(r"\s*(?P<type>\w+(?:/\w+)*)(?:<=\d+)?(?:\[[^\]]*\])?\s+\w+")
_COMMENT = re.compile(r"""(?P<code>(?:"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|[^#"']|["'])*?)\s*#.*""")


@dataclass(frozen=True)
class Line:
    """One line, as it is in the file."""

    text: str

    @property
    def code(self) -> str:
        """What is left without the comment."""
        match = _COMMENT.fullmatch(self.text)
        return match["code"].rstrip() if match else self.text.rstrip()

    def nested(self, package: str) -> str | None:
        """Return the message that is this field's type, as package/msg/Name."""
        field = _FIELD.match(self.code)
        if field is None or _PRIMITIVE.fullmatch(field["type"]):
            return None
        parts = field["type"].split("/")
        return f"{parts[0] if len(parts) > 1 else package}/msg/{parts[-1]}"
