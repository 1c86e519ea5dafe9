"""Terminal output in the documents, as it really is.

    .venv/bin/python docs/pictures.py           write it again
    .venv/bin/python docs/pictures.py --check   say whether it is still so (exit 1 if not)

Between `<!-- check:begin -->` and `<!-- check:end -->` of the README stands what two real checks of
18-publisher print: one with a known mistake, one of the reference solution. Between
`<!-- validate:begin -->` and `<!-- validate:end -->` of validating.md stands what `validate` prints of a
quiz: as it is, and with a mistake of which something else is claimed than is so. Between
`<!-- evidence:begin -->` and `<!-- evidence:end -->` of evidence.md stands what `evidence show` draws after
the same two checks. No two runs look the same there: only who publishes and who listens is compared.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from course.content import Course, open_course
from course.grading import trial

ROOT = Path(__file__).parents[1]
README = ROOT / "README.md"
EXERCISE = "18-publisher"
MISTAKE = "publisher-topic-plural"
SHOW = ("evidence", "show", EXERCISE)
VALIDATING = ROOT / "docs" / "validating.md"
QUIZ = "16-interfaces-quiz"
EVIDENCE = ROOT / "docs" / "evidence.md"
# Durations differ from run to run, and with them how wide their column is.
SECONDS = re.compile(r" +\d+\.\d+( s|\n)")
# What does not tell who publishes and who listens.
DRAWN = re.compile(r"^(?!.*─→).*\n", re.MULTILINE)


def main() -> int:
    raw = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=raw)
    parser.add_argument("--check", action="store_true")
    only_check = parser.parse_args().check
    fresh = [
        drawn(README, "check", picture, write=not only_check),
        drawn(VALIDATING, "validate", validated, write=not only_check),
        drawn(EVIDENCE, "evidence", evidence, write=not only_check, varies=DRAWN),
    ]
    return 0 if all(fresh) or not only_check else 1


def drawn(
    document: Path, name: str, draw: Callable[[], str], *, write: bool, varies: re.Pattern[str] = SECONDS
) -> bool:
    """Whether the document's picture was as it is drawn now. varies: what no two runs have in common."""
    region = re.compile(rf"(?<=<!-- {name}:begin -->\n).*?(?=<!-- {name}:end -->)", re.DOTALL)
    before = document.read_text(encoding="utf-8")
    after = region.sub(lambda _: draw(), before)
    if write:
        document.write_text(after, encoding="utf-8")
    return varies.sub("", after) == varies.sub("", before)


def validated() -> str:
    """A sound exercise, and one of which too much is claimed."""
    with tempfile.TemporaryDirectory() as folder:
        chapter = open_course(ROOT).exercise(QUIZ).folder
        for part in (chapter, ROOT / "solutions" / chapter.name):
            if part.is_dir():
                shutil.copytree(part, Path(folder, part.relative_to(ROOT)))
        Path(folder, "graders").mkdir()
        mistakes = Path(folder, "chapters", chapter.name, "mistakes.yaml")
        words = ("--course", folder, "validate", QUIZ, "--jobs", "1")
        sound = run(*words, cwd=Path(folder))
        text = mistakes.read_text(encoding="utf-8")
        first = re.search(r"says: \[.*\]", text)
        assert first is not None
        mistakes.write_text(text.replace(first[0], "says: [a circle]", 1), encoding="utf-8")
        broken = run(*words, cwd=Path(folder))
    shown = f"$ ./ros2course validate {QUIZ}\n"
    return "```console\n" + "\n".join(shown + tidy(text) for text in (sound, broken)) + "```\n"


def tidy(text: str) -> str:
    return "".join(f"{line.rstrip()}\n" for line in text.splitlines())


def picture() -> str:
    """Both checks as one code block."""
    course = open_course(ROOT)
    shown = "\n\n".join(f"$ ./ros2course check\n{checked(course, mistaken)}" for mistaken in (True, False))
    return f"```console\n{shown}\n```\n"


def evidence() -> str:
    """What `evidence show` draws of both checks."""
    course = open_course(ROOT)
    texts = []
    for mistaken in (True, False):
        with laid(course, mistaken) as home:
            run("--home", str(home), "check", EXERCISE)
            texts.append("$ ./ros2course evidence show\n" + tidy(run("--home", str(home), *SHOW)))
    return "```console\n" + "\n".join(texts) + "```\n"


def checked(course: Course, mistaken: bool) -> str:
    """What `check` prints at 80 columns, with the mistake in the solution or without."""
    with laid(course, mistaken) as home:
        return tidy(run("--home", str(home), "check", EXERCISE)).rstrip("\n")


@contextmanager
def laid(course: Course, mistaken: bool) -> Iterator[Path]:
    """A course home with the solution, with the mistake in it or without."""
    exercise = course.exercise(EXERCISE)
    with tempfile.TemporaryDirectory() as folder:
        home = Path(folder)
        trial.lay_solution(course, exercise, home)
        if mistaken:
            mistake = next(found for found in exercise.mistakes() if found.id == MISTAKE)
            trial.apply_mistake(exercise, mistake, home)
        run("init", folder)
        yield home


def run(*words: str, cwd: Path = ROOT) -> str:
    kept = {name: value for name, value in os.environ.items() if name != "GITHUB_ACTIONS"}
    settings = {"COLUMNS": "80", "NO_COLOR": "1", "ROS2COURSE_LAUNCHER": "./ros2course"}
    environment = {**kept, **settings, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-m", "course", *words]
    done = subprocess.run(command, cwd=cwd, env=environment, stdout=subprocess.PIPE, text=True, check=False)
    return done.stdout


if __name__ == "__main__":
    raise SystemExit(main())
