"""The page itself: the templates, style and script of this package, filled with the data."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterator
from functools import cache
from importlib.resources import files

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from course.report.gradebook.check_words import score
from course.report.gradebook.letter import letter
from course.report.page import views
from course.report.page.data import ClassPage, as_json, class_data, packed, submission_data

MOST_MISTAKES = 100
_ROOM = "course.report.page"
_PARTS = ("short", "overview")


def class_page(page: ClassPage) -> Iterator[str]:
    """The instructor's page, which contains everything, piece by piece."""
    yield from _pieces(page, "class", f"{page.course}: marks")


def learner_page(page: ClassPage, place: int) -> str:
    """A page for the person at that place, with nothing about anybody else and no figures of the class."""
    sheet = page.sheets[place]
    pictures = {(0, exercise): drawn for (at, exercise), drawn in page.pictures.items() if at == place}
    code = {(0, exercise): code for (at, exercise), code in page.code.items() if at == place}
    alone = ClassPage(page.course, page.exercises, (sheet,), page.began, page.ended, pictures, code)
    return "".join(_pieces(alone, "learner", f"Feedback for {sheet.person.name or sheet.person.id}"))


def live_page(page: ClassPage) -> str:
    """The instructor's page without submissions: it requests these, and updates, from its server."""
    return "".join(_pieces(page, "live", f"{page.course}: marks"))


def news(page: ClassPage) -> dict[str, object]:
    """What changes on the live page: the table's data, and parts of the page by their ids."""
    told = _figures(page)
    parts = {name: _environment().get_template(f"{name}.html.j2").render(told) for name in _PARTS}
    return {"data": class_data(page), "parts": parts}


def policy(mode: str) -> str:
    """The content security policy: only our own script and style, and nothing is fetched.

    The live page may send requests to its own server.
    """
    asks = "; connect-src 'self'" if mode == "live" else ""
    scripts, styles = _digest(_file("page.js")), _digest(_file("page.css"))
    return (
        f"default-src 'none'; script-src {scripts}; style-src {styles}{asks}; "
        "base-uri 'none'; form-action 'none'"
    )


def _pieces(page: ClassPage, mode: str, title: str) -> Iterator[str]:
    template = _environment().get_template("page.html.j2")
    told = {
        "mode": mode,
        "title": title,
        "page": page,
        "policy": policy(mode),
        "css": Markup(_file("page.css")),
        "js": Markup(_file("page.js")),
        "data": Markup(as_json(class_data(page))),
        "submissions": _submissions(page) if mode != "live" else (),
        "letter": letter(page.sheets[0], page.course) if mode == "learner" else "",
        **(_figures(page) if mode != "learner" else {}),
    }
    yield from template.generate(told)


def _submissions(page: ClassPage) -> Iterator[str]:
    return (packed(submission_data(page, place)) for place in range(len(page.sheets)))


def _figures(page: ClassPage) -> dict[str, object]:
    found = views.mistakes(page)
    bars = views.distribution(page)
    return {
        "page": page,
        "totals": views.totals(page),
        "bars": bars,
        "highest": max(1, *(bar.count for bar in bars)),
        "exercises": views.exercises(page),
        "mistakes": found[:MOST_MISTAKES],
        "more_mistakes": len(found[MOST_MISTAKES:]),
        "troubles": views.troubles(page),
        "changes": views.changes(page),
    }


def _digest(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


@cache
def _file(name: str) -> str:
    return (files(_ROOM) / "files" / name).read_text(encoding="utf-8")


@cache
def _environment() -> Environment:
    environment = Environment(
        loader=PackageLoader(_ROOM, "files"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["clock"] = _clock
    environment.filters["prose"] = _prose
    environment.filters["people"] = lambda places: ",".join(map(str, places))
    environment.globals["score"] = score
    return environment


def _prose(text: str) -> Markup:
    parts = [escape(part) for part in text.split("`")]
    if len(parts) % 2 == 0:
        return escape(text)
    code = Markup("<code>{}</code>")
    return Markup("").join(code.format(part) if odd % 2 else part for odd, part in enumerate(parts))


def _clock(seconds: float) -> str:
    """A duration for people: `4.1 s`, `2 min 5 s`, `3 h 12 min`."""
    if seconds < 60:
        return f"{seconds:.1f} s"
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes} min {rest} s" if minutes < 60 else f"{minutes // 60} h {minutes % 60} min"
