"""The page in a real browser, as people use it."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page, expect

from course.report.page.data import ClassPage, as_json
from course.report.page.html import class_page, learner_page, live_page, news
from course.report.page.serving import serving
from tests.report.page.classes import hostile, large, small

pytestmark = pytest.mark.slow

Open = Callable[..., Page]
EVERYBODY = 500


def whole(page: ClassPage) -> str:
    return "".join(class_page(page))


def names(page: Page) -> list[str]:
    return page.locator("#marks tbody th").all_inner_texts()


def test_sorting(open_page: Open) -> None:
    page = open_page(whole(small()))
    came = names(page)
    heading = page.locator("#marks th", has_text="Total")
    page.get_by_role("button", name="Total").press("Enter")
    expect(heading).to_have_attribute("aria-sort", "descending")
    assert names(page) == ["Ada Okafor", "Bảo Nguyễn", "Carl Lind", "Emre Kaya", "Dilara Aydın"]
    page.get_by_role("button", name="Total").press("Enter")
    expect(heading).to_have_attribute("aria-sort", "ascending")
    assert names(page) == ["Emre Kaya", "Carl Lind", "Bảo Nguyễn", "Ada Okafor", "Dilara Aydın"]
    page.get_by_role("button", name="Name").click()
    expect(heading).to_have_attribute("aria-sort", "none")
    page.get_by_role("button", name="Name").click()
    assert names(page) == sorted(came, reverse=True)
    page.get_by_role("button", name="Name").click()
    assert names(page) == came


def test_a_large_class_is_all_there(open_page: Open) -> None:
    page = open_page(whole(large(EVERYBODY)))
    expect(page.locator("#marks tbody tr")).to_have_count(EVERYBODY)
    page.get_by_role("button", name="Id").click()
    expect(page.locator("#marks tbody tr")).to_have_count(EVERYBODY)
    ids = page.locator("#marks tbody td.id").all_inner_texts()
    assert ids == sorted(ids)


def test_filtering(open_page: Open) -> None:
    page = open_page(whole(small()))
    page.get_by_label("Name or id").fill("nguyễn")
    expect(page.get_by_role("status").first).to_have_text("1 of 5 shown.")
    assert names(page) == ["Bảo Nguyễn"]
    page.get_by_role("button", name="Show all").click()
    expect(page.get_by_role("status").first).to_have_text("5 of 5 shown.")
    page.get_by_label("Ended with").select_option("not passed")
    assert names(page) == ["Bảo Nguyễn", "Carl Lind"]
    page.get_by_label("Ended with").select_option("")
    page.get_by_label("Exercise", exact=True).select_option(label="18-publisher")
    assert "Emre Kaya" not in names(page)


def test_those_who_made_a_mistake(open_page: Open) -> None:
    page = open_page(whole(small()))
    page.locator("#mistakes li", has_text="/amazing_quotes").get_by_role("button").press("Enter")
    assert names(page) == ["Bảo Nguyễn"]
    expect(page.locator("#shown")).to_contain_text('1 of 5 shown, of those with "The node publishes')


def test_a_submission_by_keyboard_and_back(open_page: Open) -> None:
    page = open_page(whole(small()))
    page.get_by_role("button", name="Remarks").focus()
    page.keyboard.press("Tab")
    page.keyboard.press("Tab")
    expect(page.get_by_role("link", name="Bảo Nguyễn")).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.locator("#submission-name")).to_be_focused()
    expect(page.locator("#submission-name")).to_have_text("Bảo Nguyễn")
    expect(page.locator("#people")).to_be_hidden()
    article = page.locator("#submission")
    expect(article).to_contain_text("The node publishes on /amazing_quotes, not /amazing_quote.")
    expect(article.get_by_role("img")).to_have_count(3)
    line = article.locator(".code li", has_text="The node publishes on")
    expect(line).to_contain_text("line_21 = 21")
    article.get_by_text("The same in words").first.press("Enter")
    expect(article.locator("figure details p").first).to_contain_text("6 messages, from 1.00 s to 3.50 s.")
    expect(article.locator("figure details p").first).to_be_visible()
    page.go_back()
    expect(page.get_by_role("link", name="Bảo Nguyễn")).to_be_focused()


def test_a_lasting_link_leads_to_a_person(open_page: Open) -> None:
    page = open_page(whole(small()))
    page.evaluate("location.hash = '#person-bao'")
    expect(page.locator("#submission-name")).to_have_text("Bảo Nguyễn")
    expect(page.get_by_role("link", name="permanent link")).to_have_attribute("href", "#person-bao")
    page.evaluate("location.hash = '#person-nobody'")
    expect(page.locator("#submission")).to_be_hidden()


def test_the_first_tab_skips_to_the_content(open_page: Open) -> None:
    page = open_page(whole(small()))
    page.keyboard.press("Tab")
    expect(page.get_by_role("link", name="Skip to the content")).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.locator("main")).to_be_focused()


@pytest.mark.parametrize("width", [320, 390])
def test_a_phone_scrolls_in_one_direction(open_page: Open, width: int) -> None:
    wide = hostile(["w" * 300, "Ada " * 80, "</script>"])
    for text in (whole(small()), whole(wide), learner_page(small(), 1), learner_page(wide, 0)):
        page = open_page(text, width=width)
        assert overflow(page) <= 0
        if page.locator("#marks").count():
            page.locator("#marks tbody a").first.click()
            expect(page.locator("#submission-name")).to_be_focused()
            assert overflow(page) <= 0


def overflow(page: Page) -> int:
    return int(page.evaluate("document.documentElement.scrollWidth - innerWidth"))


def test_hostile_texts_are_shown_and_do_nothing(open_page: Open) -> None:
    texts = ["</script><script>alert(1)</script>", "<img src=x onerror=alert(1)>", "\u202egnp.exe"]
    page = open_page(whole(hostile(texts)))
    assert names(page) == [*texts[:2], r"\u202egnp.exe"]
    for place, text in enumerate(names(page)):
        page.locator("#marks tbody a").nth(place).click()
        expect(page.locator("#submission-name")).to_have_text(text)
        assert page.locator("#submission script, #submission img").count() == 0
        expect(page.locator("#submission svg").first).to_be_visible()
        page.go_back()
    assert page.locator("img").count() == 0


def test_no_script_no_harm(open_page: Open) -> None:
    page = open_page(whole(small()), script=False)
    expect(page.get_by_role("rowheader", name="Carl Lind")).to_be_visible()
    expect(page.get_by_role("heading", name="Most common mistakes")).to_be_visible()
    expect(page.get_by_role("button", name="Show all")).to_be_hidden()
    learner = open_page(learner_page(small(), 2), script=False)
    expect(learner.locator("pre.letter")).to_contain_text("AttributeError")


def test_print(open_page: Open) -> None:
    page = open_page(whole(large(EVERYBODY)))
    page.emulate_media(media="print")
    expect(page.locator("#filter")).to_be_hidden()
    assert page.locator(".tall").evaluate("each => each.scrollHeight - each.clientHeight") <= 0


def test_nobody_is_moved_who_does_not_like_it(open_page: Open) -> None:
    page = open_page(whole(small()), reduced_motion="reduce")
    assert page.evaluate("getComputedStyle(document.documentElement).scrollBehavior") == "auto"


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [1280, 360])
def test_nobody_is_kept_out(open_page: Open, scheme: str, width: int) -> None:
    page = open_page(whole(small()), width=width, color_scheme=scheme)
    page.evaluate("document.querySelectorAll('details').forEach((each) => { each.open = true; })")
    assert violations(page) == []
    page.get_by_role("link", name="Carl Lind").click()
    expect(page.locator("#submission-name")).to_be_focused()
    assert violations(page) == []
    assert violations(open_page(learner_page(small(), 1), width=width, color_scheme=scheme)) == []


def violations(page: Page) -> list[str]:
    found = Axe().run(page).response["violations"]
    return [f"{one['id']}: {node['html'][:200]}" for one in found for node in one["nodes"]]


class Growing:
    """A class to which somebody comes."""

    def __init__(self) -> None:
        self.people = 3

    def page(self) -> str:
        return live_page(large(self.people))

    def tag(self) -> str:
        return str(self.people)

    def news(self) -> tuple[str, str]:
        return self.tag(), as_json(news(large(self.people)))

    def submission(self, place: int) -> str | None:
        told = {"id": "x", "name": "Just asked", "source": "", "summary": "-", "says": [], "marks": []}
        return as_json(told)


def test_the_live_page_follows(open_page: Open) -> None:
    growing = Growing()
    with serving(growing, 0) as server:
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        try:
            page = open_page(server.address)
            expect(page.locator("#marks tbody tr")).to_have_count(3)
            page.get_by_label("Ended with").select_option("not passed")
            growing.people = 8
            expect(page.locator("#shown")).to_have_text("4 of 8 shown.", timeout=60_000)
            expect(page.locator("#short dd").first).to_have_text("8")
            page.locator("#marks tbody a").first.click()
            expect(page.locator("#submission-name")).to_have_text("Just asked")
        finally:
            server.shutdown()
            thread.join()
