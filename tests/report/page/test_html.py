"""The page: well-formed, isolated, escaped; and no learner's data appears as another's."""

from __future__ import annotations

import base64
import hashlib
import re

import pytest

from course.report.page.data import ClassPage
from course.report.page.html import class_page, learner_page, live_page, news, policy
from tests.report.gradebook.hostile import MACHINE, SECRET
from tests.report.page.classes import hostile, large, small
from tests.report.page.reading import Tree, data_of, submissions_of


def whole(page: ClassPage) -> str:
    return "".join(class_page(page))


@pytest.mark.slow
def test_pages_are_well_formed() -> None:
    for page in (small(), hostile(), large(30)):
        for text in (whole(page), learner_page(page, 0), live_page(page)):
            assert Tree(text).faults == []


@pytest.mark.slow
def test_nothing_is_fetched() -> None:
    tree = Tree(whole(hostile()))
    assert not tree.tags() & {"link", "img", "iframe", "object", "embed", "base", "audio", "video"}
    assert tree.attributes("src") == [] and tree.attributes("style") == []
    assert all(link.startswith("#") for link in tree.attributes("href"))
    assert not [name for _, attributes in tree.elements for name in attributes if name.startswith("on")]


def test_only_our_own_script_and_style_run() -> None:
    text = whole(small())
    for kind, pattern in (("script-src", r"<script>(.*?)</script>"), ("style-src", r"<style>(.*?)</style>")):
        (code,) = re.findall(pattern, text, re.DOTALL)
        digest = base64.b64encode(hashlib.sha256(code.encode()).digest()).decode()
        assert f"{kind} 'sha256-{digest}'" in policy("class")
    assert "default-src 'none'" in policy("class")
    assert "connect-src" not in policy("class") and "connect-src 'self'" in policy("live")
    assert 'http-equiv="Content-Security-Policy"' in text


@pytest.mark.slow
def test_texts_of_submissions_make_no_elements() -> None:
    ours = Tree(whole(small())).tags()
    assert Tree(whole(hostile())).tags() <= ours | {"code", "li", "ol", "ul"}


@pytest.mark.slow
def test_nothing_leaves_that_must_not() -> None:
    page = hostile()
    learners = [learner_page(page, at) for at in (0, 11, 31, 32)]
    for text in (whole(page), live_page(page), str(news(page)), *learners):
        shown = text + str(submissions_of(text))
        for forbidden in (MACHINE, SECRET, "\x1b", "\u202e"):
            assert forbidden not in shown


def test_everybody_is_in_the_page_and_in_its_table_without_a_script() -> None:
    text = whole(small())
    assert len(data_of(text)["people"]) == len(submissions_of(text)) == 5
    (table,) = re.findall(r"<noscript>(.*?)</noscript>", text, re.DOTALL)
    for name in ("Ada Okafor", "Bảo Nguyễn", "Carl Lind", "Dilara Aydın", "Emre Kaya"):
        assert f'<th scope="row">{name}</th>' in table
    assert "<td>3 of 5</td>" in table and "<td>our error</td>" in table and "<td>not handed in</td>" in table


def test_a_learners_page_holds_nothing_of_others() -> None:
    page = small()
    text = learner_page(page, 1)
    (told,) = submissions_of(text)
    assert told["name"] == "Bảo Nguyễn" and len(told["marks"][0]["pictures"]) == 3
    every = text + str(told)
    for name in ("Ada", "Carl", "Dilara", "Emre", "Median", "Distribution of marks"):
        assert name not in every
    assert "Feedback for Bảo Nguyễn" in text


def test_a_learner_without_pictures_gets_none_of_anybody_else() -> None:
    (told,) = submissions_of(learner_page(small(), 2))
    assert told["name"] == "Carl Lind" and told["marks"][0]["pictures"] == []


def test_the_page_says_what_was_not_drawn() -> None:
    page = small()
    short = ClassPage(page.course, page.exercises, page.sheets, page.began, page.ended, {}, not_drawn=7)
    assert "7 recordings came without pictures" in whole(short)
    assert "came without pictures" not in whole(page)


def test_what_a_screen_reader_needs() -> None:
    for text in (whole(small()), learner_page(small(), 1)):
        tree = Tree(text)
        assert [attributes.get("lang") for tag, attributes in tree.elements if tag == "html"] == ["en"]
        assert {"header", "main", "footer", "title", "h1"} <= tree.tags()
        ids = tree.attributes("id")
        assert len(ids) == len(set(ids))
        named = " ".join(tree.attributes("aria-labelledby")).split()
        assert set(named) - {"submission-name"} <= set(ids)
        labels = {attributes["for"] for tag, attributes in tree.elements if tag == "label"}
        fields = {a["id"] for tag, a in tree.elements if tag in ("input", "select")}
        assert labels == fields
        tables = sum(tag == "table" for tag, _ in tree.elements)
        assert tables == sum(tag == "caption" for tag, _ in tree.elements)
        assert all("scope" in attributes for tag, attributes in tree.elements if tag == "th")


def test_the_live_page_has_nobody_in_it_but_the_table() -> None:
    text = live_page(small())
    assert submissions_of(text) == []
    told = news(small())
    assert told["data"] == data_of(text)
