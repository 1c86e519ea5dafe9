"""Markdown for the terminal: lessons, exercises and hints.

It differs from rich's own Markdown in what a learner needs: code can be copied (no padding to the right
edge, no wrapping at the top level), and the text stays clear without color: headings are underlined, and
code in a sentence keeps its backquotes.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar

from markdown_it.token import Token
from rich.console import Console, ConsoleOptions, RenderResult
from rich.markdown import BlockQuote, CodeBlock, Heading, ListItem, Markdown, MarkdownElement
from rich.segment import Segment
from rich.text import Text

from course.report.console import is_plain, put
from course.report.sanitize import clean

CODE_INDENT = 4


class PlainHeading(Heading):
    """A heading at the left edge, underlined if there may be no bold type."""

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        strong = "bold" if is_plain(console) else "bold magenta"
        yield Text(self.text.plain, strong)
        if is_plain(console) and self.tag in ("h1", "h2"):
            yield Text(("=" if self.tag == "h1" else "-") * min(self.text.cell_len, options.max_width))


class CopyableCode(CodeBlock):
    """A code block: indented, colored if there is color, and never padded with spaces."""

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        code = str(self.text).rstrip()
        text = Text(code, "default") if is_plain(console) else _coloured(code, self.lexer_name)
        nested = options.max_width < console.width
        for line in text.split("\n", allow_blank=True):
            yield from _code_line(console, line, options.max_width - CODE_INDENT if nested else None)


class Item(ListItem):
    """A list item with a bullet that exists in every encoding."""

    def render_bullet(self, console: Console, options: ConsoleOptions) -> RenderResult:
        lines = console.render_lines(self.elements, options.update(width=options.max_width - 4), pad=False)
        for row, line in enumerate(lines):
            yield Segment("    " if row else "  - ")
            yield from line
            yield Segment("\n")


class Quote(BlockQuote):
    """A quotation with a bar that exists in every encoding."""

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        narrower = options.update(width=options.max_width - 4)
        for line in console.render_lines(self.elements, narrower, pad=False):
            yield Segment("  | ")
            yield from line
            yield Segment("\n")


class CourseMarkdown(Markdown):
    """The course's Markdown; `plain` keeps the backquotes around code in sentences."""

    elements: ClassVar[dict[str, type[MarkdownElement]]] = {
        **Markdown.elements,
        "heading_open": PlainHeading,
        "fence": CopyableCode,
        "code_block": CopyableCode,
        "list_item_open": Item,
        "blockquote_open": Quote,
    }

    def __init__(self, text: str, *, plain: bool) -> None:
        super().__init__(clean(text), hyperlinks=False)
        if plain:
            _keep_backquotes(self.parsed)


def put_markdown(console: Console, text: str) -> None:
    """Print Markdown, without the spaces that rich adds at the ends of lines."""
    rendered = console.render(CourseMarkdown(text, plain=is_plain(console)))
    for segments in Segment.split_lines(rendered):
        line = Text.assemble(*((part.text, part.style or "") for part in segments if not part.control))
        line.rstrip()
        put(console, line)


def _keep_backquotes(tokens: Iterable[Token]) -> None:
    for token in tokens:
        if token.type == "code_inline":
            token.content = f"`{token.content}`"
        _keep_backquotes(token.children or ())


def _coloured(code: str, lexer: str) -> Text:
    # Imported only here: pygments' lexers and styles take longer to load than the rest of a lesson.
    from rich.syntax import Syntax

    text = Syntax(code, lexer, theme="ansi_light", background_color="default").highlight(code)
    text.rstrip()
    text.no_wrap = False
    return text


def _code_line(console: Console, line: Text, room: int | None) -> RenderResult:
    pieces = [line] if room is None else list(line.wrap(console, max(room, 20))) or [line]
    for piece in pieces:
        yield Segment(" " * CODE_INDENT)
        yield from (segment for segment in piece.render(console) if segment.text)
        yield Segment("\n")
