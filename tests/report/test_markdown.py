"""Lessons are readable without color, and their code can be copied."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from course.report.markdown import put_markdown

if TYPE_CHECKING:
    from tests.report.conftest import Page

LONG_LINE = 'print("' + "a line of code that goes on beyond eighty columns " * 3 + '")'
LESSON = f"""\
# Topics

A node *publishes* on a topic; `ros2 topic list` shows them. See [more](https://example.org).

## A node

```python
class Node:
    x = 1


{LONG_LINE}
```

- first, with `code` and a text that is a good deal longer than one line of the terminal
- second

1. one
2. two

> quoted

| name | type |
| --- | --- |
| `id` | int32 |
"""


def test_without_colour_everything_shows_what_it_is(page: Page) -> None:
    put_markdown(page.console, LESSON)
    assert page.lines[:2] == ["Topics", "======"]
    assert "------" in page.text.split("A node\n")[1]
    assert "`ros2 topic list`" in page.text
    assert "(https://example.org)" in page.text
    assert "  | quoted" in page.lines


def test_code_is_whole_indented_and_not_filled_up(page: Page) -> None:
    put_markdown(page.console, LESSON)
    at = page.lines.index("    class Node:")
    assert page.lines[at : at + 5] == ["    class Node:", "        x = 1", "", "", f"    {LONG_LINE}"]


def test_prose_and_lists_are_wrapped(page: Page) -> None:
    put_markdown(page.console, LESSON)
    assert [line for line in page.lines if len(line) > 80] == [f"    {LONG_LINE}"]
    assert "  - second" in page.lines


def test_no_line_ends_with_blanks(page: Page) -> None:
    put_markdown(page.console, LESSON)
    assert [line for line in page.lines if line != line.rstrip()] == []


def test_colour_replaces_backquotes_and_underlines(colour_page: Page) -> None:
    put_markdown(colour_page.console, LESSON)
    assert "\x1b[36mros2 topic list\x1b[0m" in colour_page.text
    assert "======" not in colour_page.text


def test_code_in_a_list_is_wrapped_and_not_cut(page: Page) -> None:
    words = [f"word{number}" for number in range(40)]
    put_markdown(page.console, f"- item\n\n  ```\n  {' '.join(words)}\n  ```\n")
    assert page.text.split()[2:] == words
    assert max(map(len, page.lines)) <= 80


def test_coloured_code_in_a_list_is_wrapped_too(colour_page: Page) -> None:
    words = [f"word{number}" for number in range(40)]
    put_markdown(colour_page.console, f"- item\n\n  ```bash\n  {' '.join(words)}\n  ```\n")
    text = re.sub(r"\x1b\[[0-9;]*m", "", colour_page.text)
    assert text.split()[2:] == words
    assert max(map(len, text.splitlines())) <= 80


def test_controls_in_a_lesson_do_nothing(page: Page) -> None:
    put_markdown(page.console, "# A\x1b[2J\n\n`\x1b]0;x\x07b`\n\n```\n\x1b[31mc\n```\n[bold]no markup[/bold]")
    assert "\x1b" not in page.text
    assert "[bold]no markup[/bold]" in page.text


def test_plain_code_needs_no_highlighter(page: Page) -> None:
    import subprocess
    import sys

    code = (
        "import sys; from course.report.console import open_console;"
        "from course.report.markdown import put_markdown;"
        "put_markdown(open_console(), '```python\\nx = 1\\n```');"
        "sys.exit(any(name.startswith('pygments.lexers.python') for name in sys.modules))"
    )
    assert (
        subprocess.run([sys.executable, "-c", code], stdout=subprocess.DEVNULL, check=False).returncode == 0
    )
