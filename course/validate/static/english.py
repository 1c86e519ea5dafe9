"""Plain American English: spelling, words that sound translated, long sentences, and early terms.

A line with a false alarm says why: `<!-- plain: a town of this name -->`, in Python `# plain: ...`.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterable, Iterator, Sequence
from os import EX_DATAERR
from pathlib import Path

from course.content import layout
from course.errors import UsageError
from course.model import replace
from course.validate import Finding
from course.validate.static.subject import Prose, Subject

LONGEST = 30  # words in a sentence
# A pattern, what to write instead, and an example that it must find.
RULES = [
    (r"\bblanks?\b", "space", "begins with two blanks"),
    (r"\banew\b", "again", "Write it anew."),
    (r"\bwhoever\b", "anyone who", "Whoever goes beyond is stopped."),
    (r"[«»]", "straight quotes", "say «map»"),
    (r"\b(?:stands|lies) (?:in|on|behind|beside|there)\b", "is in", "The file lies in `src`."),
    (r"(?<!there )\bis no (?!longer\b|more\b|less\b)", "is not a", "`20` is no `float64`"),
    (r"\bshall\b", "must", "What shall come before"),
    (r"\b(?:a|an) (?!(?:little|lot|few)\b)\w+ more\b(?! than)", "one more", "a folder more"),
    (r"\bby lot\b", "at random", "drawn by lot"),
    (r"\bsome times\b", "a few times", "Run it some times"),
    (r"\bcomes? to an end\b", "ends", "The program does not come to an end."),
    (r"\bknows? of\b", "knows about", "None of it knows of ROS yet"),
    (r"\bbe it\b", "even", "A slip, be it a comma"),
    (r"\bhas to do with\b", "is about", "what it has to do with it"),
    (r"\bholds (?:a|an|the|no|its|all|one|only|more|other|\d+)\b(?! locks?\b| terminal\b| handles?\b)",
     "contains", "A file that holds the answers"),
    (r"\bfor what (?:is|are) done\b", "for jobs that", "for what is done quickly"),
    (r"\b(?:is|are) meant by\b", "means", "it is meant by *the workspace*"),
    (r"\bcan be said\b", "you can put into words", "can do what can be said"),
    (r"\bnobody can explain\b", "baffling", "fails in ways that nobody can explain"),
    (r"\bthe (?:first|last) time that it is\b", "the last chapter", "the last time that it is about tools"),
    (r"\bwhat it \w+ you \w+", "you see its output", "what it prints you see"),
    (r"\b(?:it|node|program) falls\b", "crashes", "and then the node falls"),
    (r"\bsome (?:ten|hundred|thousand)\b", "hundreds of", "ROS brings some hundred along"),
    (r"\bto do with\?", "is about", "what has this node to do with?"),
    (r"\bin its own way\b", "predictably", "must not fail in its own way"),
    (r"\bof all that your?\b", "only", "Of all that your file sets"),
    (r"\b(?:what|belongs|comes) behind\b", "after", "A space belongs behind each `:`"),
    (r"\bcannot be \w+ (?:is|are) told\b", "It reports what", "What cannot be set is told"),
]  # fmt: skip
# ROS and asyncio spell it `cancelled`.
_CODESPELL = (sys.executable, *"-m codespell_lib --builtin clear,en-GB_to_en-US -L cancelled --".split())
_ALLOWED = re.compile(r"(?:<!--|#|//) plain: \w")
_CODE = re.compile(r"^ *```.*?^ *```|`[^`\n]+`", re.DOTALL | re.MULTILINE)
_BLOCKS = re.compile(r"^ *```.*?^ *```", re.DOTALL | re.MULTILINE)
_PARAGRAPH = re.compile(r"(?:(?!\n\s*\n|\n *(?:[-*|#>]|\d+\.) ).)+", re.DOTALL)
# Up to 30 words that are repeated at once, or eight words that are repeated later.
_TWICE = re.compile(
    r"(?<!\S)(?!again\b|`)((?=\S*[a-z])\S+(?:\s+\S+){0,29})\s+\1(?!\S)"
    r"|(?<!\S)(?P<run>[^\s|]+(?:\s+[^\s|]+){7})(?=\s.*?\s(?P=run)(?!\S))",
    re.DOTALL,
)


def english_findings(texts: Iterable[Prose]) -> Iterator[Finding]:
    for text in texts:
        for line, what, step in plain_findings(text.text):
            yield Finding(text.file, text.at(line), what, step, text.exercise)


def spelling_findings(course: Path) -> Iterator[Finding]:
    """What codespell finds in texts and graders. `codespell:ignore WORD` in a line allows the word there.

    Raises UsageError if the course has settings that codespell cannot read.
    """
    wanted = ("chapters/*/*.md", f"chapters/*/{layout.LESSON}", f"{layout.GRADERS}/**/*.py")
    files = sorted(file for pattern in wanted for file in course.glob(pattern))
    done = subprocess.run([*_CODESPELL, *files], cwd=course, capture_output=True, text=True)
    if done.returncode not in (0, EX_DATAERR):
        raise UsageError(
            f"codespell: {done.stderr.strip()[-200:]}", "correct the settings of codespell in the course"
        )
    for line in done.stdout.splitlines():
        file, number, words = line.split(":", 2)
        word, _, right = words.strip().partition(" ==> ")
        yield Finding(Path(file), int(number), f"`{word}` is misspelled, or British", f"write: {right}")


def plain_findings(text: str) -> Iterator[tuple[int, str, str]]:
    """For a Markdown text: the line (from 1), what is wrong, what to do."""
    yield from odd_words(text)
    yield from long_sentences(text)
    yield from repetitions(text)


def odd_words(text: str) -> Iterator[tuple[int, str, str]]:
    """For a Markdown text, without its code: the line (from 1), what is wrong, what to do."""
    for number, line in enumerate(_without_code(text).splitlines(), 1):
        for pattern, instead, _example in RULES:
            found = re.search(pattern, line, re.IGNORECASE)
            if found and not _ALLOWED.search(line):
                yield number, f"`{found[0]}` is not plain American English", f"write: {instead}"


def long_sentences(text: str) -> Iterator[tuple[int, str, str]]:
    """For paragraphs and list items, not for tables: the line (from 1), what is wrong, what to do."""
    plain = _without_code(text)
    for paragraph in _PARAGRAPH.finditer(plain):
        for sentence in re.finditer(r"\S(?:(?![.!?:]\s).)*[.!?:]?", paragraph[0], re.DOTALL):
            words = [word for word in sentence[0].split() if re.search(r"\w", word)]
            is_table = paragraph[0].lstrip().startswith("|")
            if len(words) > LONGEST and not is_table and not _ALLOWED.search(paragraph[0]):
                line = plain.count("\n", 0, paragraph.start() + sentence.start()) + 1
                start = " ".join(words[:5])
                yield line, f"`{start} ...` has {len(words)} words", f"split it: at most {LONGEST} a sentence"


def repetitions(text: str) -> Iterator[tuple[int, str, str]]:
    """Repeated words, outside of tables and code blocks: the line (from 1), what is wrong, what to do."""
    plain = re.sub(r"^> ?", "", _without_code(text, _BLOCKS), flags=re.MULTILINE)
    for paragraph in _PARAGRAPH.finditer(plain):
        found = _TWICE.search(paragraph[0])
        is_prose = not re.match(r"\s*\||\n*    ", paragraph[0])
        if found and is_prose and not _ALLOWED.search(paragraph[0]):
            line = plain.count("\n", 0, paragraph.start() + found.start()) + 1
            words = " ".join((found[1] or found["run"]).split())
            yield line, f"`{words}` appears twice", "delete one of the two"


def early_terms(subject: Subject, texts: Sequence[Prose]) -> Iterator[Finding]:
    """Places where a text uses one of the `terms` before the lesson that explains it in bold."""
    plain = [replace(text, text=_without_code(text.text)) for text in texts]
    earlier: list[Prose] = []
    for chapter, reading in subject.lessons.items():
        own = [text for text in plain if str(text.file).startswith(f"{chapter}/")]
        lesson = own[0].text if own else ""
        for place, term in enumerate(reading.value["terms"] if reading.value else ()):
            words = r"\s+".join(map(re.escape, term.split())) + "s?"
            if bold := re.search(rf"\*\*{words}[.,]?\*\*", lesson, re.IGNORECASE):
                what = f"`{term}` is used before {chapter.name} explains it"
                for text in (*earlier, replace(own[0], text=lesson[: bold.start()])):
                    for line in _lines_with(words, text):
                        yield Finding(text.file, line, what, "explain it, or use other words", text.exercise)
            elif reading.document:
                line, what = reading.document.line(("terms", place)), f"the lesson does not explain `{term}`"
                yield Finding(reading.document.file, line, what, f"write **{term}** where it does")
        earlier += own


def _lines_with(words: str, text: Prose) -> Iterator[int]:
    """The lines of the file with these words, without headings, for a text without its code."""
    for found in re.finditer(rf"\b{words}\b", text.text, re.IGNORECASE):
        number = text.text.count("\n", 0, found.start())
        line = text.text.splitlines()[number]
        if not line.startswith("#") and not _ALLOWED.search(line):
            yield text.at(number + 1)


def _without_code(text: str, code: re.Pattern[str] = _CODE) -> str:
    """The text with the same lines, and an X in place of each piece of code."""
    return code.sub(lambda found: "X" + "\n" * found[0].count("\n"), text)
