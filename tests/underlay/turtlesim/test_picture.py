"""What was drawn, and how a terminal shows it."""

from __future__ import annotations

import fcntl
import os
import pty
import struct
import sys
import termios
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pyte
import pytest

_SOURCE = Path(__file__).parents[3] / "underlay" / "src" / "turtlesim"
RED, BLUE = (255, 0, 0), (0, 0, 255)
BLANK = "\u2800"


@pytest.fixture(scope="module", autouse=True)
def _turtlesim_is_importable() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.syspath_prepend(str(_SOURCE))
        yield
    for name in [name for name in sys.modules if name.startswith("turtlesim_programs")]:
        del sys.modules[name]


@pytest.fixture
def canvas() -> Any:
    from turtlesim_programs.canvas import Canvas

    return Canvas()


def _plain(canvas: Any, height: int, *turtles: tuple[float, float, float]) -> list[str]:
    screen = pyte.Screen(2 * height, height)
    pyte.Stream(screen).feed("\r\n".join(canvas.picture(height, BLUE, turtles)))
    return list(screen.display)


def test_a_canvas_is_white_until_something_is_drawn(canvas: Any) -> None:
    assert canvas.color_at(5, 5) == (255, 255, 255)
    assert _plain(canvas, 8) == [BLANK * 16] * 8


def test_a_line_is_as_wide_as_the_pen(canvas: Any) -> None:
    canvas.line((2, 5), (8, 5), RED, 9)
    assert canvas.color_at(2, 5) == canvas.color_at(5, 5) == canvas.color_at(8, 5) == RED
    assert canvas.color_at(5, 5 + 4 / 45) == RED
    assert canvas.color_at(5, 5 + 6 / 45) == canvas.color_at(5, 5 - 6 / 45) == (255, 255, 255)
    canvas.clear()
    assert canvas.color_at(5, 5) == (255, 255, 255)


@pytest.mark.parametrize("width", [1, 30, 255])
def test_a_line_along_the_edge_stays_on_the_canvas(canvas: Any, width: int) -> None:
    canvas.line((0, 0), (0, 100), RED, width)
    assert canvas.color_at(0, 0) == canvas.color_at(0, 11) == RED
    assert canvas.color_at(11, 5) == (255, 255, 255)


def test_a_picture_shows_places_where_they_are(canvas: Any) -> None:
    canvas.line((0, 11), (0, 11), RED, 1)
    canvas.line((11, 0.1), (11, 0.1), RED, 1)
    rows = _plain(canvas, 10)
    assert rows[0] == "\u2801" + BLANK * 19
    assert rows[9].strip(BLANK) and rows[9][:19] == BLANK * 19


@pytest.mark.parametrize(
    ("theta", "arrow"),
    [(0, "→"), (0.79, "↗"), (1.57, "↑"), (3.14, "←"), (-3.14, "←"), (-1.57, "↓"), (-0.79, "↘")],
)
def test_an_arrow_points_where_the_turtle_does(canvas: Any, theta: float, arrow: str) -> None:
    rows = _plain(canvas, 10, (5.6, 5.6, theta))
    assert [arrow in row for row in rows].index(True) == 4
    assert rows[4].index(arrow) == 10


class _Window:
    """A terminal, and what it shows."""

    def __init__(self, lines: int, columns: int) -> None:
        self._near, far = pty.openpty()
        self.terminal = os.fdopen(far, "w", encoding="utf-8")
        fcntl.ioctl(self._near, termios.TIOCSWINSZ, struct.pack("HHHH", lines, columns, 0, 0))
        self._screen = pyte.Screen(columns, lines)
        self._stream = pyte.Stream(self._screen)

    def close(self) -> None:
        self.terminal.close()
        os.close(self._near)

    def rows(self) -> list[str]:
        """After everything that was written so far: the kernel passes it on in pieces, and a little later."""
        end, shown = "\x1b]0;end\x07", ""
        self.terminal.write(end)
        self.terminal.flush()
        while end not in shown:
            shown += os.read(self._near, 65536).decode()
        self._stream.feed(shown)
        return [row.rstrip() for row in self._screen.display]


@pytest.fixture
def open_window() -> Iterator[Callable[[int, int], _Window]]:
    opened: list[_Window] = []

    def open_one(lines: int, columns: int) -> _Window:
        opened.append(_Window(lines, columns))
        return opened[-1]

    yield open_one
    for window in opened:
        window.close()


def test_lines_scroll_below_the_picture(open_window: Callable[[int, int], _Window]) -> None:
    from turtlesim_programs.screen import Screen

    window = open_window(20, 80)
    window.terminal.write("before\n")
    screen = Screen(window.terminal)
    screen.draw(lambda height: [str(number) for number in range(height)])
    for number in range(20):
        window.terminal.write(f"line {number}\n")
    screen.draw(lambda height: [str(number) for number in range(height)])
    rows = window.rows()
    assert rows[:14] == [str(number) for number in range(14)]
    assert rows[14:] == [f"line {number}" for number in range(15, 20)] + [""]
    screen.close()
    for number in range(30):
        window.terminal.write(f"after {number}\n")
    window.terminal.flush()
    assert window.rows()[0] == "after 11"


def test_a_small_window_shows_no_picture(open_window: Callable[[int, int], _Window]) -> None:
    from turtlesim_programs.screen import Screen

    window = open_window(13, 80)
    Screen(window.terminal).draw(lambda height: ["never"] * height)
    window.terminal.write("here\n")
    window.terminal.flush()
    assert window.rows()[0] == "here"


def test_a_file_gets_no_picture(tmp_path: Path) -> None:
    from turtlesim_programs.screen import Screen

    with (tmp_path / "log").open("w") as file:
        Screen(file).draw(lambda height: ["never"] * height)
    assert not (tmp_path / "log").read_text()
