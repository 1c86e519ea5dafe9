"""A new exercise in a chapter: texts, starter, solution, grader and mistakes, which prove one another."""

from __future__ import annotations

from pathlib import Path

from course.authoring.append import with_code, with_item
from course.authoring.course_folder import require_place
from course.authoring.fill import Words, filled
from course.authoring.names import ExerciseName, number_and_slug, titled
from course.authoring.schemas import missing_schemas
from course.authoring.write import Made, Plan, carry_out
from course.content import layout
from course.content.names import did_you_mean
from course.errors import ContentError, UsageError

# Below the package's folder, in the solution and in the starter; the node is another one there.
_PACKAGE = {
    "package.xml": "package.xml",
    "setup.py": "setup.py",
    "setup.cfg": "setup.cfg",
    "resource/{package}": "marker",
    "{package}/__init__.py": "marker",
    "{package}/{node}.py": "{side}/node.py",
}


def new_exercise(root: Path, place: str) -> Made:
    """Add the exercise of `30-power/30-battery`, chapter and name.

    The chapter may be given by its number; the exercise's own number may be left out.
    Raises UsageError, ContentError for a file that it cannot be added to, StorageError.
    """
    require_place(root)
    chapter_name, slash, wanted = place.partition("/")
    if not slash or not wanted:
        step = "allowed: chapter and exercise, like `30-power/30-battery`"
        raise UsageError(f"`{place}` does not say in which chapter the exercise belongs", step)
    chapter = _chapter(root, chapter_name)
    own = int(chapter.name[:2])
    number, slug = number_and_slug(wanted, own)
    if number != own:
        step = f"allowed: {own:02d}-{slug}"
        raise UsageError(f"an exercise of {chapter.name} has that chapter's number, not {number}", step)
    exercise = ExerciseName(own, slug)
    _refuse_same_package(root, exercise)
    return carry_out(_plan(root, chapter, exercise), root, exercise.id)


def _chapter(root: Path, name: str) -> Path:
    folders = {folder.name: folder for folder in layout.chapter_folders(root)}
    for known, folder in folders.items():
        ways = (known, known[:2], known[:2].lstrip("0"), known[3:])
        if layout.CHAPTER_FOLDER.fullmatch(known) and name in ways:
            return folder
    have = f"there are: {', '.join(folders)}; " if folders else ""
    step = f"{have}`ros2course new chapter NAME --course {root}` makes one"
    raise UsageError(f"there is no chapter `{name}`{did_you_mean(name, folders)}", step)


def _refuse_same_package(root: Path, exercise: ExerciseName) -> None:
    """All chapters' packages meet in one workspace, that of the learner."""
    other = next(root.glob(f"solutions/*/{layout.WORKSPACE}/src/{exercise.package}"), None)
    if other is not None:
        what = f"there is a package {exercise.package} already: {other.relative_to(root)}"
        raise UsageError(what, "choose another name for the exercise")


def _plan(root: Path, chapter: Path, exercise: ExerciseName) -> Plan:
    words = _words(chapter, exercise)
    grader, lesson, mistakes = layout.grader_file(chapter), chapter / layout.LESSON, chapter / layout.MISTAKES
    new = {
        layout.exercise_text(chapter, exercise.id): filled("exercise/exercise.md", words),
        **_package(layout.starter_folder(chapter, exercise.id), "starter", words),
        **_package(layout.solution_folder(chapter), "solution", words),
        **missing_schemas(root),
    }
    changed = {lesson: with_item(lesson, _read(lesson), "exercises", filled("exercise/lesson.yaml", words))}
    listed = filled("exercise/mistakes.yaml", words)
    if mistakes.exists():
        changed[mistakes] = with_item(mistakes, _read(mistakes), "mistakes", listed)
    else:
        new[mistakes] = f"mistakes:\n{listed}"
    imports, code = filled("exercise/imports.py", words), filled("exercise/grader.py", words)
    if grader.exists():
        changed[grader] = with_code(grader, _read(grader), imports, code)
    else:
        new[grader] = filled("exercise/head.py", words) + imports + "\n" + code
    return Plan(new, changed)


def _words(chapter: Path, exercise: ExerciseName) -> dict[str, str]:
    return {
        "number": str(exercise.number),
        "chapter_title": titled(chapter.name[3:]),
        "exercise": exercise.id,
        "title": exercise.title,
        "slug": exercise.slug,
        "name": exercise.snake,
        "package": exercise.package,
        "node": exercise.node,
        "class_name": exercise.node_class,
        "workspace": layout.WORKSPACE,
        "source": f"{layout.WORKSPACE}/src/{exercise.package}",
    }


def _package(tree: Path, side: str, words: Words) -> dict[Path, str]:
    folder = tree / words["source"]
    return {
        folder / target.format(**words): filled(f"exercise/{template.format(side=side)}", words)
        for target, template in _PACKAGE.items()
    }


def _read(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise ContentError("this is not UTF-8 text", "save it as UTF-8", file=file) from None
    except OSError as error:
        raise ContentError(
            f"cannot be read: {error.strerror}", "create it, or ask its owner", file=file
        ) from None
