"""A new exercise in a chapter: texts, starter, solution, grader and mistakes, which test one another."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path

from course.authoring.append import with_code, with_item
from course.authoring.course_folder import NewChapter, number_and_slug, require_place, titled
from course.authoring.write import Made, Plan, Words, carry_out, filled, missing_schemas
from course.content import layout
from course.errors import ContentError, UsageError
from course.spelling import did_you_mean


class ExerciseKind(str, Enum):
    """What a new exercise is about."""

    TOPIC = "topic"
    SERVICE = "service"
    ACTION = "action"
    PARAMETER = "parameter"
    LAUNCH = "launch"
    LIBRARY = "library"
    QUIZ = "quiz"
    MYSTERY = "mystery"


# The package's files and their templates. `{side}` is `solution` or `starter`.
_PACKAGE = {
    "package.xml": "exercise/package.xml",
    "setup.py": "exercise/setup.py",
    "setup.cfg": "exercise/setup.cfg",
    "resource/{package}": "exercise/marker",
    "{package}/__init__.py": "exercise/marker",
}
_NODE = {**_PACKAGE, "{package}/{node}.py": "{kind}/{side}.py"}
_ENTRY = "            '{node} = {package}.{node}:main',\n"
_LAUNCH_FILE = "        ('share/' + package_name + '/launch', ['launch/{name}_launch.py']),\n"


@dataclass(frozen=True)
class _Recipe:
    """What a kind consists of, besides its text, its entry in lesson.yaml, its checks and its mistakes.

    package: its files, with their templates; none for a kind without a package. depends: for package.xml;
    one of the mistakes removes the last one. entries, installs: lines of setup.py. beside: other files,
    relative to the course. is_node: whether the mistakes that every node can have apply.
    """

    package: Mapping[str, str] = field(default_factory=dict)
    depends: tuple[str, ...] = ()
    entries: str = ""
    installs: str = ""
    beside: Mapping[str, str] = field(default_factory=dict)
    is_node: bool = False


def _node(interfaces: str) -> _Recipe:
    return _Recipe(_NODE, ("rclpy", interfaces), _ENTRY, is_node=True)


_LAUNCHED = {
    **_PACKAGE,
    "{package}/{node}.py": "topic/solution.py",
    "launch/{name}_launch.py": "launch/{side}.py",
}
_RECIPES = {
    ExerciseKind.TOPIC: _node("std_msgs"),
    ExerciseKind.SERVICE: _node("std_srvs"),
    ExerciseKind.ACTION: _node("example_interfaces"),
    ExerciseKind.PARAMETER: _node("std_msgs"),
    ExerciseKind.LAUNCH: _Recipe(_LAUNCHED, ("rclpy", "std_msgs", "launch_ros"), _ENTRY, _LAUNCH_FILE),
    ExerciseKind.LIBRARY: _Recipe({**_PACKAGE, "{package}/{name}.py": "library/{side}.py"}),
    ExerciseKind.QUIZ: _Recipe(),
    ExerciseKind.MYSTERY: _Recipe(beside={"chapters/{chapter}/play/{exercise}.py": "mystery/play.py"}),
}


def new_exercise(root: Path, place: str, kind: ExerciseKind = ExerciseKind.TOPIC) -> Made:
    """Add the exercise `30-battery` to the chapter `30-power`. place: `30-power/30-battery`.

    The chapter may be given by its number; the exercise's own number may be left out. Raises UsageError,
    StorageError, and ContentError for a file to which it cannot be added.
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
    if _RECIPES[kind].package:
        _refuse_same_package(root, exercise)
    return carry_out(_plan(root, chapter, exercise, kind), root, exercise.id)


def _chapter(root: Path, name: str) -> Path:
    folders = {folder.name: folder for folder in layout.chapter_folders(root)}
    for known, folder in folders.items():
        ways = (known, known[:2], known[:2].lstrip("0"), known[3:])
        if layout.CHAPTER_FOLDER.fullmatch(known) and name in ways:
            return folder
    have = f"there are: {', '.join(folders)}; " if folders else ""
    step = f"{have}`ros2course new chapter NAME --course {root}` creates one"
    raise UsageError(f"there is no chapter `{name}`{did_you_mean(name, folders)}", step)


def _refuse_same_package(root: Path, exercise: ExerciseName) -> None:
    """All chapters share the learner's workspace, so package names must be unique."""
    other = next(root.glob(f"solutions/*/{layout.WORKSPACE}/src/{exercise.package}"), None)
    if other is not None:
        what = f"there already is a package {exercise.package}: {other.relative_to(root)}"
        raise UsageError(what, "choose another name for the exercise")


def _plan(root: Path, chapter: Path, exercise: ExerciseName, kind: ExerciseKind) -> Plan:
    recipe = _RECIPES[kind]
    words = _words(chapter, exercise, kind)
    lesson, mistakes = chapter / layout.LESSON, chapter / layout.MISTAKES
    new = {
        layout.exercise_text(chapter, exercise.id): filled(f"{kind.value}/exercise.md", words),
        **_package(layout.starter_folder(chapter, exercise.id), "starter", recipe, words),
        **_package(layout.solution_folder(chapter), "solution", recipe, words),
        **{root / file.format(**words): filled(template, words) for file, template in recipe.beside.items()},
        **missing_schemas(root),
    }
    item = filled(f"{kind.value}/lesson.yaml", words)
    changed = {lesson: with_item(lesson, _read(lesson), "exercises", item)}
    apply = {"exercise": bool(recipe.package), "node": recipe.is_node, kind.value: True}
    folders = (folder for folder, applies in apply.items() if applies)
    listed = "\n".join(filled(f"{folder}/mistakes.yaml", words) for folder in folders)
    if mistakes.exists():
        changed[mistakes] = with_item(mistakes, _read(mistakes), "mistakes", listed)
    else:
        new[mistakes] = f"mistakes:\n{listed}"
    if kind is not ExerciseKind.QUIZ:
        grader = layout.grader_file(chapter)
        imports, code = filled(f"{kind.value}/imports.py", words), filled(f"{kind.value}/grader.py", words)
        if grader.exists():
            changed[grader] = with_code(grader, _read(grader), imports, code)
        else:
            new[grader] = filled("exercise/head.py", words) + imports + "\n" + code
    return Plan(new, changed)


def _words(chapter: Path, exercise: ExerciseName, kind: ExerciseKind) -> dict[str, str]:
    recipe = _RECIPES[kind]
    words = {
        "number": str(exercise.number),
        "chapter": chapter.name,
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
        "kind": kind.value,
    }
    return {
        **words,
        "depends": "\n".join(f"  <depend>{name}</depend>" for name in recipe.depends),
        "interfaces": recipe.depends[-1] if recipe.depends else "",
        "entries": recipe.entries.format(**words),
        "installs": recipe.installs.format(**words),
    }


def _package(tree: Path, side: str, recipe: _Recipe, words: Words) -> dict[Path, str]:
    folder, own = tree / words["source"], {**words, "side": side}
    files = recipe.package.items()
    return {folder / target.format(**own): filled(template.format(**own), own) for target, template in files}


def _read(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise ContentError("this is not UTF-8 text", "save it as UTF-8", file=file) from None
    except OSError as error:
        raise ContentError(
            f"cannot be read: {error.strerror}", "create it, or ask its owner", file=file
        ) from None


class ExerciseName(NewChapter):
    """`30-battery-level`: its id, and the names of its package, node, topic and Python code."""

    @property
    def snake(self) -> str:
        return self.slug.replace("-", "_")

    @property
    def package(self) -> str:
        return f"{self.snake}_package"

    @property
    def node(self) -> str:
        return f"{self.snake}_node"

    @property
    def node_class(self) -> str:
        return "".join(part.capitalize() for part in self.slug.split("-")) + "Node"
