"""What the turtles have drawn, and a picture of it in characters."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

Color = tuple[int, int, int]

PIXELS = 500
METER = 45
SIZE = (PIXELS - 1) / METER
"""The canvas is a square of this side, in meters; the origin is its lower left corner."""

_UNTOUCHED = 255
# Bits of a character of Braille, of which each is two dots wide and four high.
_DOTS = np.array([[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]], dtype=np.uint8)
_BRAILLE = 0x2800
_ARROWS = "→↗↑↖←↙↓↘"
_TURTLE: Color = (255, 255, 255)


class Canvas:
    """A square of 500 x 500 pixels."""

    def __init__(self) -> None:
        self.clear()

    def clear(self) -> None:
        """Remove everything that was drawn."""
        self._colors = np.full((PIXELS, PIXELS, 3), _UNTOUCHED, dtype=np.uint8)
        self._drawn = np.zeros((PIXELS, PIXELS), dtype=bool)

    def line(self, start: tuple[float, float], end: tuple[float, float], color: Color, width: int) -> None:
        """Draw from `start` to `end` (meters) with a pen that is `width` pixels wide."""
        (row, column), (last_row, last_column) = _pixel(*start), _pixel(*end)
        steps = max(abs(last_row - row), abs(last_column - column), 1)
        for step in range(steps + 1):
            top = row + round((last_row - row) * step / steps) - width // 2
            left = column + round((last_column - column) * step / steps) - width // 2
            spot = (slice(max(top, 0), max(top + width, 0)), slice(max(left, 0), max(left + width, 0)))
            self._colors[spot] = color
            self._drawn[spot] = True

    def color_at(self, x: float, y: float) -> Color:
        """The color at a place (meters): white where nothing was drawn."""
        red, green, blue = self._colors[_pixel(x, y)]
        return int(red), int(green), int(blue)

    def picture(
        self, height: int, background: Color, turtles: Iterable[tuple[float, float, float]]
    ) -> list[str]:
        """As `height` lines of twice as many characters; an arrow for each turtle (x, y, theta)."""
        rows, columns = np.nonzero(self._drawn)
        down, right = rows * 4 * height // PIXELS, columns * 4 * height // PIXELS
        cells = (down // 4, right // 2)
        dots = np.zeros((height, 2 * height), dtype=np.uint8)
        np.bitwise_or.at(dots, cells, _DOTS[down % 4, right % 2])
        colors = np.full((height, 2 * height, 3), _UNTOUCHED, dtype=np.uint8)
        colors[cells] = self._colors[rows, columns]
        characters = [[chr(_BRAILLE + bits) for bits in row] for row in dots.tolist()]
        for x, y, theta in turtles:
            row, column = _pixel(x, y)
            cell = (row * height // PIXELS, column * 2 * height // PIXELS)
            characters[cell[0]][cell[1]] = _ARROWS[round(theta / (np.pi / 4)) % 8]
            colors[cell] = _TURTLE
        return [_colored(*line, background) for line in zip(characters, colors.tolist(), strict=True)]


def _pixel(x: float, y: float) -> tuple[int, int]:
    """Row and column of a place, moved onto the canvas if it is outside."""
    row, column = round((SIZE - y) * METER), round(x * METER)
    return min(max(row, 0), PIXELS - 1), min(max(column, 0), PIXELS - 1)


def _colored(characters: list[str], colors: list[list[int]], background: Color) -> str:
    said = [f"\x1b[48;2;{background[0]};{background[1]};{background[2]}m"]
    before: list[int] | None = None
    for character, color in zip(characters, colors, strict=True):
        if color != before:
            said.append(f"\x1b[38;2;{color[0]};{color[1]};{color[2]}m")
        before = color
        said.append(character)
    return "".join([*said, "\x1b[0m"])
