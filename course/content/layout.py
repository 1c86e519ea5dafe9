"""Where things are in a course folder: the only module that knows its file names."""

from __future__ import annotations

import re
from importlib.machinery import PathFinder
from pathlib import Path

from course.errors import OurFault, UsageError
from course.spelling import did_you_mean

LESSON = "lesson.yaml"
LESSON_TEXT = "lesson.md"
MISTAKES = "mistakes.yaml"
PROGRAMS = "programs"  # scripts for questions that ask for their output
ALTERNATIVE = "alternative.yaml"
# Lists what to build in a solution, one per line: the folder of a workspace, with options for colcon; or the
# folder of a CMake project, with options for cmake, which is also installed.
BUILT = "built.txt"
GRADERS = "graders"
PARTS = ("chapters", GRADERS, "solutions")
# In every course home and solution: the workspace of an exercise's packages, unless it names another one.
WORKSPACE = "ros2_tutorial_workspace"
# In a course home: the course's own data.
STATE = ".ros2course"
CHAPTER_FOLDER = re.compile(r"(\d\d)-[a-z0-9]+(-[a-z0-9]+)*")


def own_root(package: Path) -> Path:
    """The course that ships with the engine: next to it in a checkout, otherwise inside it."""
    for root in (package.parent, package / "_course"):
        if (root / "chapters").is_dir():
            return root
    raise OurFault(f"the lessons are missing from this installation ({package})", "install ros2course again")


def require_course(root: Path) -> None:
    """Raises UsageError, naming what is missing, if the folder is not a course."""
    try:
        lack = _lack(root)
    except PermissionError as error:
        raise UsageError(f"{root} is not readable: {error.strerror}", "ask its owner for access") from None
    if lack:
        form = f"a course contains chapters/NN-name/{LESSON}, graders/, and solutions/"
        raise UsageError(f"{root} is not a course: {lack}", form)


def _lack(root: Path) -> str | None:
    if not root.is_dir():
        return "there is no such folder"
    if not (root / "chapters").is_dir():
        return f"it has no {', '.join(f'{part}/' for part in PARTS if not (root / part).is_dir())}"
    return None if chapter_folders(root) else "there is no chapter in its chapters/ folder"


def chapter_folders(root: Path) -> tuple[Path, ...]:
    """All folders in chapters/ except hidden ones, in order. `lesson` reports bad names."""
    folders = (path for path in (root / "chapters").iterdir() if path.is_dir())
    return tuple(sorted(path for path in folders if path.name[0] not in "._"))


def grader_file(chapter: Path) -> Path:
    """`graders/ch18_publishers_and_subscribers.py` for `chapters/18-publishers-and-subscribers`."""
    return chapter.parents[1] / "graders" / f"ch{chapter.name.replace('-', '_')}.py"


def solution_folder(chapter: Path) -> Path:
    return chapter.parents[1] / "solutions" / chapter.name


def starter_folder(chapter: Path, exercise: str) -> Path:
    return chapter / "starter" / exercise


def play_file(chapter: Path, exercise: str) -> Path | None:
    """The module of the exercise's mystery, `play/ID.py` or `play/ID/__init__.py`; None when it has none."""
    candidates = (chapter / "play" / f"{exercise}.py", chapter / "play" / exercise / "__init__.py")
    return next((file for file in candidates if file.is_file()), None)


def answers_file(exercise: str) -> str:
    """The file with a learner's answers to the exercise's questions, relative to the course home."""
    return f"answers/{exercise}.yaml"


def exercise_text(chapter: Path, exercise: str) -> Path:
    return chapter / f"{exercise}.md"


# Where an installed package contains a course: at its top level, or in a folder next to its code.
_INSIDE = ("", "_course")


def named_course(name: str) -> Path:
    """The folder of this name, or the course in the installed package of this name; nothing is imported.

    Raises UsageError if there is neither. A folder need not be a course yet.
    """
    folder = Path(name).expanduser()
    if folder.exists() or not name.isidentifier():
        return folder
    found = PathFinder.find_spec(name)
    if found is None:
        near = did_you_mean(name, (path.name for path in Path().iterdir() if path.is_dir()))
        what = f"there is no course folder `{name}` here, and no installed package of that name{near}"
        raise UsageError(what, "give the course's folder: `--course DIR`")
    return _inside(name, tuple(map(Path, found.submodule_search_locations or ())))


def _inside(name: str, places: tuple[Path, ...]) -> Path:
    roots = (place / inside for place in places for inside in _INSIDE)
    course = next((root for root in roots if (root / "chapters").is_dir()), None)
    if course is None:
        where = f" ({places[0]})" if places else ""
        raise UsageError(
            f"the installed package {name}{where} contains no course",
            "a course contains chapters/, graders/, and solutions/",
        )
    return course


ADDED_TO = frozenset({".bashrc"})


def with_addition(text: str, addition: str) -> str:
    """`text` with `addition` as its last lines; unchanged if it already contains them."""
    if addition.strip() in text:
        return text
    return f"{text.rstrip()}\n\n{addition}" if text.strip() else addition
