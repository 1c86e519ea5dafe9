"""What the observer notes inside a program, with every Python from 3.10 on that this machine has."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import textwrap
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.arena import observer_program
from course.model import codec
from course.model.events import Observed


def works(python: str | None) -> bool:
    if python is None:
        return False
    return subprocess.run([python, "-c", ""], capture_output=True).returncode == 0


# On the path, or installed beside the one that runs these tests.
MINORS = [minor for minor in range(10, 15) if minor != sys.version_info.minor]
BESIDE = [str(file) for file in Path(sys.base_prefix).parent.glob("3.1?.*/bin/python3.1?")]
FOUND = [shutil.which(f"python3.{minor}") for minor in MINORS] + BESIDE
OTHERS = {Path(file).name: file for file in FOUND if file and works(file)}
PYTHONS = [sys.executable, *(OTHERS[f"python3.{minor}"] for minor in MINORS if f"python3.{minor}" in OTHERS)]


@pytest.fixture(params=PYTHONS, ids=lambda python: Path(python).name)
def python(request: pytest.FixtureRequest) -> str:
    return str(request.param)


LOOPED = f"_LOOPED = {observer_program._LOOPED}\n"


class Watched:
    """A folder with the observer and a program. `run` returns the notes, and keeps the output.

    looped: seconds after which a callback counts as endless; with other Pythons this comes sooner.
    """

    def __init__(self, folder: Path, python: str) -> None:
        self.folder, self._python = folder, python
        self.printed = ""
        self.looped = observer_program._LOOPED if python == sys.executable else 3.0
        observer = folder / "observer"
        observer.mkdir()
        text = Path(observer_program.__file__).read_text()
        assert LOOPED in text
        (observer / "sitecustomize.py").write_text(text.replace(LOOPED, f"_LOOPED = {self.looped}\n"))
        home = folder / "home"
        home.mkdir()
        told = {"roots": [str(home)], "names": ["talker.py", "words.py"], "folder": str(home / "notes")}
        (observer / "observer.json").write_text(json.dumps(told))

    def run(self, text: str, *, interrupt_after: str = "", **files: str) -> list[Observed]:
        home = self.folder / "home"
        for name, content in {"talker": text, **files}.items():
            (home / f"{name}.py").write_text(textwrap.dedent(content))
        env = {**os.environ, "PYTHONPATH": str(self.folder / "observer"), "PYTHONUNBUFFERED": "1"}
        command = [self._python, str(home / "talker.py")]
        pipe = subprocess.PIPE
        with subprocess.Popen(
            command, env=env, cwd=home, stdout=pipe, stderr=subprocess.STDOUT, text=True
        ) as program:
            assert program.stdout is not None
            if interrupt_after:
                for line in program.stdout:
                    if interrupt_after in line:
                        break
                self._until(interrupt_after, program)
                program.send_signal(signal.SIGINT)
            self.printed = program.communicate(timeout=30)[0]
        return list(self._notes())

    def _until(self, what: str, program: subprocess.Popen[str]) -> None:
        """A stop is noted after a second, a loop after ten."""
        while program.poll() is None and not any(note.what != "ran" for note in self._notes()):
            threading.Event().wait(0.05)

    def _notes(self) -> Iterator[Observed]:
        for file in sorted((self.folder / "home/notes").glob("*")):
            for line in file.read_text().splitlines():
                yield codec.from_json(line, Observed, "a note")


@pytest.fixture
def watched(tmp_path: Path, python: str) -> Watched:
    return Watched(tmp_path, python)


def places(note: Observed) -> tuple[int | None, int | None]:
    return (note.raised.line if note.raised else None, note.by.line if note.by else None)


def the(notes: list[Observed], what: str) -> list[tuple[str, int | None, int | None]]:
    return [(note.error, *places(note)) for note in notes if note.what == what]


def test_a_hidden_error(watched: Watched) -> None:
    notes = watched.run(
        """\
        import words
        try:
            words.say(1)
        except Exception as e:
            print(e)
        """,
        words="""\
        def say(what):
            return what + "!"
        """,
    )
    error = "TypeError: unsupported operand type(s) for +: 'int' and 'str'"
    assert the(notes, "caught") == [(error, 2, 4)]
    raised = next(note.raised for note in notes if note.what == "caught")
    assert raised is not None and raised.file.endswith("/home/words.py")
    assert "unsupported operand" in watched.printed


def test_only_the_except_that_takes_it(watched: Watched) -> None:
    notes = watched.run(
        """\
        def one():
            try: int("x")
            except TypeError: pass
            except ValueError: pass
        def two():
            try:
                int("x")
            except TypeError:
                pass
            finally:
                one()
        try:
            two()
        except: pass
        """
    )
    errors = the(notes, "caught")
    assert [by for _, _, by in errors] == [4, 14]
    assert [raised for _, raised, _ in errors] == [2, 7]


def test_the_same_error_is_noted_once_and_others_not_without_end(watched: Watched) -> None:
    text = "for i in range(999):\n    try:\n        raise OSError({})\n    except OSError:\n        pass\n"
    assert len(the(watched.run(text.format("1")), "caught")) == 1
    assert len(the(watched.run(text.format("i, 'x' * 9999")), "caught")) == observer_program.MOST_NOTES + 1
    notes = watched.folder / "home/notes"
    assert sum(file.stat().st_size for file in notes.iterdir()) < 200_000


def test_a_thread_that_dies(watched: Watched) -> None:
    notes = watched.run(
        """\
        import threading
        def loop():
            nothing.say()
        thread = threading.Thread(target=loop)
        thread.start()
        thread.join()
        """
    )
    assert the(notes, "died") == [("NameError: name 'nothing' is not defined", 3, None)]
    assert "Exception in thread" in watched.printed


def test_a_task_that_dies(watched: Watched) -> None:
    notes = watched.run(
        """\
        import asyncio
        async def fails():
            return 1 / 0
        async def main():
            task = asyncio.create_task(fails())
            await asyncio.sleep(1)
            del task
            await asyncio.sleep(0.1)
        asyncio.run(main())
        """
    )
    assert the(notes, "died") == [("ZeroDivisionError: division by zero", 3, None)]


def test_a_call_that_does_not_return(watched: Watched) -> None:
    text = """\
    import threading
    print("waiting", flush=True)
    threading.Event().wait()
    """
    notes = watched.run(text, interrupt_after="waiting")
    stood = [note for note in notes if note.what == "stood"]
    assert {places(note) for note in stood} == {(None, 3)}
    assert all(note.seconds >= 1 for note in stood), "it did not go on"


def test_one_that_took_its_time_and_went_on(watched: Watched) -> None:
    notes = watched.run("import time\ntime.sleep(1.9)\ntime.sleep(0.5)\n")
    assert [note.seconds > 0 for note in notes if note.what == "stood"] == [True, False]


def test_one_that_goes_on_again_and_again(watched: Watched) -> None:
    notes = watched.run("import time\nfor _ in range(3):\n    time.sleep(1.9)\ntime.sleep(0.5)\n")
    assert [note.seconds > 0 for note in notes if note.what == "stood"] == [True, False] * 3


def test_a_loop_in_a_callback(watched: Watched) -> None:
    """Foreign functions call it, as rclpy calls a timer's callback."""
    notes = watched.run(
        """\
        import threading
        def callback():
            print("called", flush=True)
            while not threading.Event().is_set():
                pass
        exec(compile("def call(function): function()", "others.py", "exec"))
        call(callback)
        """,
        interrupt_after="called",
    )
    looped = [note for note in notes if note.what == "looped"]
    assert all(note.seconds >= watched.looped for note in looped), "it did not return"
    assert looped and {note.error for note in looped} == {"called back"}
    assert all(note.by and note.by.line in (4, 5) for note in looped)


LONG = """\
import time
def callback():
    end = time.monotonic() + {}
    while time.monotonic() < end:
        pass
exec(compile("def call(function): function()", "others.py", "exec"))
call(callback)
time.sleep(0.5)
"""


def test_a_callback_that_takes_its_time(watched: Watched) -> None:
    """It may take seconds while it is observed, and a few hundredths otherwise."""
    assert [note for note in watched.run(LONG.format(0.3 * watched.looped)) if note.what == "looped"] == []


def test_a_callback_that_returned_is_no_endless_one(watched: Watched) -> None:
    notes = watched.run(LONG.format(watched.looped + 3.0))  # three seconds for a busy machine
    assert [note.seconds >= watched.looped for note in notes if note.what == "looped"] == [True, False]


def test_lines_that_ran(watched: Watched) -> None:
    notes = watched.run("def main():\n    print(1)\n    print(2)\n\nif __name__ == 'main':\n    main()\n")
    lines = {line for note in notes if note.what == "ran" for line in note.lines}
    assert lines == {1, 5}


def test_what_is_not_the_learners_is_not_watched(watched: Watched, tmp_path: Path) -> None:
    other = tmp_path / "home" / "generated.py"
    other.write_text("try:\n    raise ValueError\nexcept ValueError:\n    pass\n")
    assert the(watched.run("import generated\nimport json\n"), "caught") == []
