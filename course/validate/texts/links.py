"""Whether links in texts lead to something. Those to the internet are not followed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from urllib.parse import unquote, urlsplit

from course.content.names import did_you_mean
from course.validate.model import Finding
from course.validate.texts.markdown import Link, contents
from course.validate.texts.prose import Prose
from course.validate.texts.subject import text_of


def link_findings(texts: Sequence[Prose]) -> Iterator[Finding]:
    for text in texts:
        for link in contents(text.text).links:
            problem = _problem(text, link)
            if problem:
                yield Finding(text.file, text.at(link.line), *problem, text.exercise)


def linked_files(texts: Sequence[Prose]) -> frozenset[Path]:
    """The files that links lead to."""
    found = (_place(text, link) for text in texts for link in contents(text.text).links)
    return frozenset(file for file, _anchor in filter(None, found))


def _place(text: Prose, link: Link) -> tuple[Path, str] | None:
    """File and anchor; None for an address in the internet, or none that can be read."""
    try:
        parts = urlsplit(link.target)
    except ValueError:
        return None
    if parts.scheme or parts.netloc:
        return None
    file = (text.file.parent / unquote(parts.path)).resolve() if parts.path else text.file
    return file, unquote(parts.fragment)


def _problem(text: Prose, link: Link) -> tuple[str, str] | None:
    place = _place(text, link)
    if place is None:
        return None
    file, anchor = place
    if not file.exists():
        near = [path.name for path in text.file.parent.iterdir()]
        what = f"the link to `{link.target}` leads nowhere{did_you_mean(link.target, near)}"
        return what, "name a file that exists, seen from the folder of this text"
    anchors = contents(text_of(file) or "").anchors if file.suffix == ".md" else frozenset()
    if anchor and anchor not in anchors:
        what = f"{file.name} has no heading `#{anchor}`{did_you_mean(anchor, anchors)}"
        return what, f"its headings: {', '.join(sorted(anchors)) or 'none'}"
    return None
