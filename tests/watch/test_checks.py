"""One check at a time in a separate process: restarts, crashes, ends; nothing is left."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Awaitable, Callable
from pathlib import Path

import pytest

from course import child
from course.content import Exercise
from course.home import create_home
from course.model.result import Verdict
from course.watch import checks as module
from course.watch.checks import CheckProcess, Checks
from course.watch.updates import Checked, Message, Said, SoFar
from tests.processes import none_stays
from tests.watch.pretended import LIGHT

pytestmark = pytest.mark.slow
PATIENCE = 60


class Room:
    """A course home with a lantern, and `Checks` that check it."""

    def __init__(self, folder: Path, course: Path) -> None:
        self.home = create_home(folder / "home").path
        (self.home / LIGHT).parent.mkdir(parents=True)
        self.heard: asyncio.Queue[Message] = asyncio.Queue()
        self.checks = Checks(course, self.home, self.heard.put_nowait)
        self._calls = folder / "calls"

    def light(self, told: str) -> None:
        (self.home / LIGHT).write_text(told)

    def calls(self) -> list[str]:
        return self._calls.read_text().splitlines()

    async def answer(self, number: int) -> Message:
        """What ends that check. Nothing of an earlier one may come."""
        while True:
            message = await self.heard.get()
            assert message.number == number
            if not isinstance(message, Said):
                return message

    async def said(self, text: str) -> None:
        while (message := await self.heard.get()) != Said(message.number, text):
            pass


Act = Callable[[Room], Awaitable[None]]


@pytest.fixture
def serve(tmp_path: Path, small_course: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[Act], Room]:
    """Run a test's actions while checks are served; afterwards no process is left."""
    monkeypatch.setattr(module, "WORKER", "tests.watch.pretended")
    monkeypatch.setenv("PYTHONPATH", str(Path(__file__).parents[2]))

    def run(act: Act) -> Room:
        async def serving() -> Room:
            room = Room(tmp_path, small_course)
            served = asyncio.ensure_future(room.checks.serve())
            try:
                await asyncio.wait_for(act(room), PATIENCE)
            finally:
                served.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await served
            return room

        with none_stays():
            return asyncio.run(serving())

    return run


def test_one_process_checks_one_after_another(serve: Callable[[Act], Room], light: Exercise) -> None:
    async def act(room: Room) -> None:
        for told, verdict in (("dark", Verdict.NOT_PASSED), ("bright", Verdict.PASSED)):
            room.light(told)
            answer = await room.answer(room.checks.start(light))
            assert isinstance(answer, Checked) and answer.result.verdict is verdict

    serve(act)


def test_a_new_one_begins_when_the_old_one_has_ended(serve: Callable[[Act], Room], light: Exercise) -> None:
    async def act(room: Room) -> None:
        room.light("waits")
        room.checks.start(light)
        await room.said("looking at the waits lantern")
        room.light("bright")
        for _ in range(5):  # several before it has ended: only the last counts
            number = room.checks.start(light)
        await room.answer(number)

    assert serve(act).calls() == ["began waits", "ended waits", "began bright"]


def test_called_off_it_says_nothing_more(serve: Callable[[Act], Room], light: Exercise) -> None:
    async def act(room: Room) -> None:
        room.light("waits")
        room.checks.start(light)
        await room.said("looking at the waits lantern")
        room.checks.stop()
        room.light("dark")
        await room.answer(room.checks.start(light))

    assert serve(act).calls() == ["began waits", "ended waits", "began dark"]


def test_cancelled_in_the_middle_everything_ends(serve: Callable[[Act], Room], light: Exercise) -> None:
    async def act(room: Room) -> None:
        room.light("waits")
        room.checks.start(light)
        await room.said("looking at the waits lantern")

    assert serve(act).calls() == ["began waits", "ended waits"]


@pytest.mark.parametrize("told", ["seeks", "seeks and falls"])
def test_what_is_certain_stays_when_the_search_for_the_cause_falls(
    serve: Callable[[Act], Room], light: Exercise, told: str
) -> None:
    async def act(room: Room) -> None:
        room.light(told)
        first = await room.answer(room.checks.start(light))
        assert isinstance(first, SoFar)
        last = await room.heard.get()
        assert isinstance(last, Checked) and (last.result == first.result) is (told == "seeks and falls")

    serve(act)


@pytest.mark.parametrize("turns", range(6))
def test_who_is_cancelled_while_a_process_ends_is_told_so(
    serve: Callable[[Act], Room], monkeypatch: pytest.MonkeyPatch, turns: int
) -> None:
    """Even at the very moment when it has ended: otherwise `watch` never ends."""

    async def act(room: Room) -> None:
        process, over = CheckProcess(), asyncio.Event()
        monkeypatch.setattr(process, "_is_over", over.wait)
        ending = asyncio.ensure_future(process.end())
        for _ in range(5):  # of the loop: until it waits
            await asyncio.sleep(0)
        over.set()
        for _ in range(turns):
            await asyncio.sleep(0)
        ending.cancel()
        with pytest.raises(asyncio.CancelledError):
            await ending
        await process.end()

    serve(act)


@pytest.mark.parametrize(
    ("told", "said"), [("falls", "out of oil"), ("breaks", "the wick"), ("lacks", "lamp oil"), ("lots", "")]
)
def test_what_fails_is_told_and_the_next_one_works(
    serve: Callable[[Act], Room],
    light: Exercise,
    monkeypatch: pytest.MonkeyPatch,
    told: str,
    said: str,
) -> None:
    if told == "lots":
        monkeypatch.setattr(child, "LONGEST_LINE", 1000)
        told = "flood"

    async def act(room: Room) -> None:
        room.light(told)
        first = await room.answer(room.checks.start(light))
        if isinstance(first, Checked):
            assert first.result.verdict is Verdict.OUR_ERROR
        assert said in repr(first)
        monkeypatch.undo()
        monkeypatch.setattr(module, "WORKER", "tests.watch.pretended")
        room.light("bright")
        second = await room.answer(room.checks.start(light))
        assert isinstance(second, Checked)

    serve(act)
