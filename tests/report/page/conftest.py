"""A real browser: Debian's chromium."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, sync_playwright

Open = Callable[..., Page]


# Not of the session: an event loop runs in this thread as long as the browser does, and others want theirs.
@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    program = shutil.which("chromium")
    assert program, "chromium is not installed: see run-tests"
    with sync_playwright() as player:
        # Root has no sandbox of its own in chromium; the pages are our own.
        browser = player.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture
def open_page(browser: Browser, tmp_path: Path) -> Iterator[Open]:
    """`open_page(text, width=360)`: the page in a new window, ready. No page may complain of anything."""
    complaints: list[str] = []
    contexts = []

    def open_(source: str, *, width: int = 1280, script: bool = True, **options: Any) -> Page:
        if not source.startswith("http"):
            file = tmp_path / f"page{len(contexts)}.html"
            file.write_text(source, encoding="utf-8")
            source = file.as_uri()
        size = {"width": width, "height": 800}
        context = browser.new_context(viewport=size, java_script_enabled=script, **options)  # type: ignore[arg-type]
        contexts.append(context)
        page = context.new_page()
        page.set_default_timeout(60_000)
        page.on("console", lambda message: complaints.append(message.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on("dialog", lambda dialog: complaints.append(f"dialog {dialog.message}"))
        page.goto(source)
        if script:
            page.wait_for_selector("html[data-ready]", state="attached")
        return page

    yield open_
    for context in contexts:
        context.close()
    assert complaints == []
