"""Fills in the templates of new files."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.resources import files
from string import Template

Words = Mapping[str, str]


def filled(name: str, words: Words) -> str:
    """The template `templates/NAME.in` with its words; `$$` in it is a plain `$`.

    A word that is missing is our fault and raises KeyError.
    """
    text = (files("course.authoring") / "templates" / f"{name}.in").read_text(encoding="utf-8")
    return Template(text).substitute(words)
