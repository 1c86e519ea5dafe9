"""Reads setup.py and setup.cfg without running them, and explains why a Python package cannot be built."""

from __future__ import annotations

import ast
import configparser
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath

from course.evidence.sources import Sources
from course.explain.builds import Build, tag
from course.explain.engine import Cause, Known, Proven, Symptom, Words, at, like
from course.explain.python_code import parsed
from course.model.feedback import Location
from course.spelling import nearest

_GROUP = "console_scripts"
_LONGEST_CONFIG = 16 * 1024
_BARE = r"^\s*[\w-]+\s*=\s*[\w.]+:\w+\s*,?\s*$"
_ENTRY_POINT = re.compile(r"\s*[\w.-]+\s*=\s*[^\W\d][\w.]*\s*:\s*[^\W\d][\w.]*\s*")

# ------------------------------------------------------------------------------------- what they say


@dataclass(frozen=True)
class EntryPoint:
    """`name = module:function` and where it is. text: the string as written. last: its last line."""

    name: str
    target: str
    text: str
    where: Location
    last: int | None = None

    @property
    def is_joined(self) -> bool:
        """Whether it is really two entries: without a comma, Python joins adjacent strings."""
        return "=" in self.target or self.target.count(":") > 1

    @property
    def is_sound(self) -> bool:
        return _ENTRY_POINT.fullmatch(self.text) is not None

    def file_in(self, folder: str) -> str:
        """The file of the target's module, for a package in this folder."""
        module = self.target.partition(":")[0].strip()
        return f"{folder}/{module.replace('.', '/')}.py"


def starts_another(sources: Sources, seen: str, wanted: str) -> Cause | None:
    """The entry point is wrong: the node that runs is in one file, and the one that should is in another."""
    names = (seen.lstrip("/"), wanted)
    modules = {file: text for file, text in sources.files.items() if re.search(r"(?<!setup)\.py$", file)}
    quoted = {
        one: [f for f, text in modules.items() if re.search(rf"['\"]{one}['\"]", text)] for one in names
    }
    runs, should = (quoted[one] for one in names)
    if len(runs) != 1 or len(should) != 1 or runs == should:
        return None
    stem, right = (PurePosixPath(one[0]).stem for one in (runs, should))
    folder = str(PurePosixPath(should[0]).parents[1])
    wrong = [entry for entry in entry_points(sources, folder) if f".{stem}:" in entry.target]
    if not wrong:
        return None
    text = f"This entry point starts `{stem}`. The node `{wanted}` is in `{right}`: use that module instead."
    of_another = next((entry for entry in wrong if entry.name != stem), wrong[0])
    return Cause(text, (of_another.where, Location(should[0])))


def entry_points(sources: Sources, package_folder: str) -> tuple[EntryPoint, ...]:
    """Return all console scripts that the package in this folder declares literally."""
    return (
        *_from_setup_py(sources, f"{package_folder}/setup.py"),
        *_from_setup_cfg(sources, f"{package_folder}/setup.cfg"),
    )


def misspelled_group(sources: Sources, package_folder: str) -> Cause | None:
    """A key of `entry_points` in setup.py that is nearly `console_scripts`."""
    file = f"{package_folder}/setup.py"
    tree = parsed(sources.files.get(file, ""))
    for node in ast.walk(tree) if tree else ():
        for key in node.keys if isinstance(node, ast.Dict) else ():
            text = str(key.value) if isinstance(key, ast.Constant) else ""
            if key and text != _GROUP and nearest(_GROUP, [text]):
                return Cause(f"`{text}` must be `{_GROUP}`: correct the name.", (Location(file, key.lineno),))
    return None


def joined_entry_points(sources: Sources, package_folder: str) -> EntryPoint | None:
    return next((one for one in entry_points(sources, package_folder) if one.is_joined), None)


def packages_place(sources: Sources, package_folder: str) -> tuple[Location, ...]:
    """Return where setup.py says which Python packages it installs."""
    file = f"{package_folder}/setup.py"
    lines = enumerate(sources.files.get(file, "").splitlines(), 1)
    given = (Location(file, number) for number, line in lines if "packages" in line and "=" in line)
    return (next(given, Location(file)),)


def _from_setup_py(sources: Sources, file: str) -> tuple[EntryPoint, ...]:
    tree = parsed(sources.files.get(file, ""))
    if tree is None:
        return ()
    names = _constants(tree)
    found = (line for value in _console_scripts(tree) for line in _lines(value, names))
    return tuple(_entry(text, Location(file, first), last) for text, first, last in found)


def _console_scripts(tree: ast.Module) -> Iterator[ast.expr]:
    """The value of `'console_scripts': ...` or `dict(console_scripts=...)`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Dict):
            pairs = zip(node.keys, node.values, strict=True)
            yield from (v for k, v in pairs if isinstance(k, ast.Constant) and k.value == _GROUP)
        elif isinstance(node, ast.keyword) and node.arg == _GROUP:
            yield node.value


def _lines(value: ast.expr, names: Mapping[str, ast.expr]) -> Iterator[tuple[str, int, int | None]]:
    """The entries of a list, or of a string with one per line, each with its first and last line."""
    value = names.get(value.id, value) if isinstance(value, ast.Name) else value
    if isinstance(value, ast.List | ast.Tuple):
        texts = ((_text(item, names), item.lineno, item.end_lineno) for item in value.elts)
        yield from ((text, first, last) for text, first, last in texts if text is not None)
    else:
        every = enumerate((_text(value, names) or "").splitlines(), start=value.lineno)
        yield from ((text.strip(), number, number) for number, text in every if text.strip())


def _text(node: ast.expr, names: Mapping[str, ast.expr]) -> str | None:
    """The value of a string, as far as it is known without running the file."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else None
    if isinstance(node, ast.Name):
        return _text(names[node.id], {}) if node.id in names else None
    if isinstance(node, ast.FormattedValue):
        return _text(node.value, names)
    if isinstance(node, ast.BinOp):
        return _joined((node.left, node.right), names) if isinstance(node.op, ast.Add) else None
    return _joined(node.values, names) if isinstance(node, ast.JoinedStr) else None


def _joined(parts: Sequence[ast.expr], names: Mapping[str, ast.expr]) -> str | None:
    texts = [_text(part, names) for part in parts]
    return None if None in texts else "".join(text or "" for text in texts)


def _constants(tree: ast.Module) -> dict[str, ast.expr]:
    """Values assigned to plain names at the top of the file, such as `package_name`."""
    given = (node for node in tree.body if isinstance(node, ast.Assign))
    return {
        target.id: node.value for node in given for target in node.targets if isinstance(target, ast.Name)
    }


def _from_setup_cfg(sources: Sources, file: str) -> tuple[EntryPoint, ...]:
    whole = sources.files.get(file, "")
    parser = read_setup_cfg(whole)
    text = parser.get("options.entry_points", _GROUP, fallback="") if parser else ""
    entries = [line.strip() for line in text.splitlines() if line.strip()]
    return tuple(_entry(entry, Location(file, _line_of(entry, whole))) for entry in entries)


def read_setup_cfg(text: str) -> configparser.ConfigParser | None:
    """Return the parsed file; None if setuptools cannot read it, or it is unreasonably long."""
    parser = configparser.ConfigParser(interpolation=None)
    if len(text) > _LONGEST_CONFIG:  # the parser collects an error for each line, more and more slowly
        return None
    try:
        parser.read_string(text)
    except configparser.Error:
        return None
    return parser


def _line_of(text: str, whole: str) -> int | None:
    return next((number for number, line in enumerate(whole.splitlines(), start=1) if text in line), None)


def _entry(text: str, where: Location, last: int | None = None) -> EntryPoint:
    name, _, target = text.partition("=")
    return EntryPoint(name.strip(), target.strip(), text, where, last)


# --------------------------------------------------------------------- why a package cannot be built

_FRAME = re.compile(r'^\s*File "(.+?)", line (\d+)')
_EXCEPTION = re.compile(
    r"^(?:[\w.]+\.)?(?P<kind>\w*(?:Error|Exception|Warning|Exit|Interrupt))(?:: (?P<said>.*))?$"
)
_NO_SETUP_PY = "there is no readable setup.py"


def log_errors(build: Build) -> list[Symptom]:
    """What setuptools reported about files."""
    setup = build.place("setup.py")
    return [Symptom(line, setup, (line,)) for line in build.lines if line.startswith("error: ")]


def setup_errors(build: Build) -> list[Symptom]:
    """What setup.py prints when run alone, because colcon swallows or buries it."""
    setup = build.place("setup.py")
    if not build.text("setup.py") and setup.file not in build.sources.others:
        return [Symptom(_NO_SETUP_PY, tag("build_type")(build, Symptom(""), {}))]
    never = [Symptom(line, setup) for line in build.lines if "was never called" in line]
    return [*_said(build.ask_setup_py(), setup)] or never  # colcon reports this for any error in setup.py


def _said(said: Sequence[str], setup: Location) -> Iterator[Symptom]:
    error = next((found for line in reversed(said) if (found := _EXCEPTION.match(line))), None)
    if error is None:
        yield from (
            Symptom(line, setup, (line,)) for line in said if line.startswith(("error in ", "error: "))
        )
        return
    yield Symptom(" ".join(said), setup, (error[0],))
    own = [number for number, line in enumerate(said) if _own_line(line)]
    start = own[-1] if own else 0
    telling = [said[start].strip(), *said[start + 1 :][:3], *said[start + 4 :][-2:]] if own else said[-4:]
    where = Location(setup.file, _own_line(said[start])) if own else setup
    yield Symptom(f"{error['kind']}: {error['said'] or ''}", where, tuple(telling))


def _own_line(line: str) -> int | None:
    found = _FRAME.match(line)
    return int(found[2]) if found and PurePosixPath(found[1]).name == "setup.py" else None


def _cmake_package(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    return Proven() if build.text("CMakeLists.txt") else None


def _leads_out(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    return Proven() if (build.copy / "setup.py").is_symlink() else None


def _empty(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    return Proven() if build.place("setup.py").file in build.sources.files else None


def _other_name(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    return Proven() if words["name"] != build.name else None


def _bare_entry(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """`talk = package.module:main` without quotes."""
    line = build.line("setup.py", _BARE)
    if line is None:
        return None
    place = build.place("setup.py", line)
    return Proven({"line": str(line), "entry": build.shown(place)[0].rstrip(",")}, (place,))


def _other_marker(build: Build, symptom: Symptom, words: Words) -> Proven:
    others = [file for file in build.files() if file.startswith("resource/")]
    return Proven({"other": others[0]} if len(others) == 1 else {})


def _in_a_folder(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """`find_packages('src')` without `package_dir`."""
    text = build.text("setup.py")
    found = re.search(r"find_packages\(\s*(?:where\s*=\s*)?['\"](?P<inside>[\w/]+)['\"]", text)
    return Proven({"inside": found["inside"]}) if found and "package_dir" not in text else None


def _line_of_setup_cfg(build: Build, symptom: Symptom, words: Words) -> Proven:
    return Proven(where=(build.place("setup.cfg", int(words["line"])),))


def _joined_entry(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    one = joined_entry_points(build.sources, build.folder)
    if one is None:
        return None
    return Proven({"line": str(one.where.line), "second": str(one.last or one.where.line)}, (one.where,))


def _unsound_entry(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    every = entry_points(build.sources, build.folder)
    one = next((one for one in every if not one.is_sound), None)
    return Proven({"line": str(one.where.line), "seen": one.text}, (one.where,)) if one else None


_NAMES_DIFFER = "Use the same name in both, in setup.cfg, for the folder, and for the file in resource/."
_STOPS = "setup.py of `{package}` stops with {error}: {said}."
_REFUSED = r"^error(?: in .*? setup command)?: (?P<said>.*?)\.?$"
_JOINED = "setup(entry_points={'console_scripts': [\n 'a = m:f'\n 'b = m:g',\n]})"
_SLASH = "setup(entry_points={'console_scripts': [\n 'a = m/f.py:g',\n]})"

# Files that setup.py names but that do not exist, as reported in colcon's log.
OF_FILES: tuple[Known[Build], ...] = (
    Known(kind="names-differ", pattern=r"^error: can't copy 'resource/(?P<name>[^']+)': doesn't exist",
          cause="setup.py calls the package `{name}`, but package.xml calls it `{package}`.",
          remedy=_NAMES_DIFFER, proof=_other_name, where=(at("setup.py", r"['\"]{name}['\"]"), tag("name")),
          example="error: can't copy 'resource/tolk': doesn't exist or not a regular file"),
    Known(kind="marker-missing", pattern=r"^error: can't copy 'resource/[^']+': doesn't exist",
          cause="The empty file resource/{package} is missing: it tells ROS that this package exists.",
          remedy=("Rename {other} to resource/{package}.", "Create it: `touch resource/{package}`."),
          proof=_other_marker, where=(at("resource/{package}"), at("setup.py", r"['\"]resource/")),
          example="error: can't copy 'resource/talk': doesn't exist or not a regular file"),
    Known(kind="data-file", pattern=r"^error: can't copy '(?P<name>[^']*\*[^']*)': doesn't exist",
          cause="setup.py of `{package}` treats the pattern {name} as the name of a file.",
          remedy="`glob` finds the files that match a pattern: write `glob('{name}')` instead of "
          "`['{name}']`.",
          where=(at("setup.py", "{name}", "data_files"),),
          example="error: can't copy 'launch/*launch.py': doesn't exist or not a regular file"),
    Known(kind="data-file", pattern=r"^error: can't copy '(?P<name>(?:.*/)?(?P<base>[^/']*))': doesn't exist",
          cause="setup.py of `{package}` installs {name}, but there is no such file.",
          remedy=("Did you mean `{near}`?", "Create the file, or remove it from `data_files`."),
          proof=like(Build.files), where=(at("setup.py", "{base}", "data_files"),),
          example="error: can't copy 'launch/talk.launch.py': doesn't exist or not a regular file"),
    Known(kind="package-dir", pattern=r"^error: package directory '(?P<name>[^'/]+)' does not exist",
          cause="setup.py of `{package}` finds {name} in `{inside}`, but then looks for it elsewhere.",
          remedy="Say where it is: add `package_dir={'': '{inside}'},` to `setup(...)`.",
          where=(at("setup.py", r"\bpackages\s*="),), proof=_in_a_folder,
          given={"setup.py": "setup(packages=find_packages('src'))"},
          example="error: package directory 'talk' does not exist"),
    Known(kind="package-folder", pattern=r"^error: package directory '(?P<name>.+?)' does not exist",
          cause="setup.py of `{package}` lists the Python package {name}, but there is no such folder.",
          remedy="`packages=find_packages(exclude=['test'])` finds every folder that has an `__init__.py`.",
          where=(at("setup.py", r"\bpackages\s*="),),
          example="error: package directory 'tolk' does not exist"),
)  # fmt: skip
# What setup.py itself prints when run alone.
OF_SETUP: tuple[Known[Build], ...] = (
    Known(kind="build-type", pattern=f"^{_NO_SETUP_PY}",
          cause="package.xml of `{package}` has the build type ament_python, but there is a CMakeLists.txt "
                "and no setup.py.",
          remedy="If it is a CMake package, write `<build_type>ament_cmake</build_type>`.",
          proof=_cmake_package, example=_NO_SETUP_PY, given={"CMakeLists.txt": "project(talk)"}),
    Known(kind="setup-py", pattern=f"^{_NO_SETUP_PY}",
          cause="setup.py of `{package}` is a link to a file outside the course home, or to a missing file.",
          remedy="Replace it with the file itself.", proof=_leads_out, where=(at("setup.py"),),
          example=_NO_SETUP_PY, given={"setup.py": "-> /etc/hostname"}),
    Known(kind="setup-py", pattern=f"^{_NO_SETUP_PY}", cause="setup.py of `{package}` is empty.", remedy="",
          proof=_empty, where=(at("setup.py"),), example=_NO_SETUP_PY, given={"setup.py": ""}),
    Known(kind="setup-missing", pattern=f"^{_NO_SETUP_PY}",
          cause="`{package}` has no setup.py, but a package of type ament_python needs one to be built.",
          remedy=("Create a new package with `ros2 pkg create {package} --build-type ament_python` and "
                 "compare."),
          example=_NO_SETUP_PY),
    Known(kind="setup-cfg", pattern=r"setup\.cfg'[,:]?\s*\[?line:?\s+(?P<line>\d+)",
          cause="setup.cfg of `{package}` cannot be read: line {line} is wrong.",
          remedy=("It should contain sections such as `[install]` and lines such as "
                 "`install_scripts=$base/lib/{package}`."), proof=_line_of_setup_cfg,
          example="MissingSectionHeaderError: File contains no section headers. file: 'setup.cfg', line: 1"),
    Known(kind="setup-py", pattern=r"^SyntaxError: unterminated string literal",
          cause="In setup.py of `{package}`, a quote is missing.",
          remedy="Each string needs a quote at its beginning and the same one at its end.",
          example="SyntaxError: unterminated string literal (detected at line 22)"),
    Known(kind="setup-py", pattern=r"^SyntaxError: ",
          cause="In setup.py of `{package}`, the entry point on line {line} has no quotes.",
          remedy="An entry point is a string: put quotes around `{entry}`.", proof=_bare_entry,
          example="SyntaxError: invalid syntax. Perhaps you forgot a comma?",
          given={"setup.py": "scripts = [\n    talk = talk.talker:main,\n]\n"}),
    Known(kind="setup-py", pattern=r"^(?:SyntaxError|IndentationError|TabError): (?P<said>.*?)[?.]*$",
          cause="setup.py of `{package}` is not Python: {said}.",
          remedy="Check that line and the one above it for a missing comma, quote or bracket.",
          example="SyntaxError: '[' was never closed"),
    *(
        Known[Build](
            kind="setup-py",
            pattern=rf"^(?P<error>NameError): (?P<said>name '(?:{names})' is not defined.*?)\.?$",
            cause=_STOPS,
            remedy=f"Add `{line}` at the top of setup.py.",
            example=f"NameError: name '{names.split('|')[0]}' is not defined",
        )
        for names, line in (
            ("glob", "from glob import glob"),
            ("os", "import os"),
            ("find_packages|setup", "from setuptools import find_packages, setup"),
            ("Path", "from pathlib import Path"),
        )
    ),
    Known(kind="setup-py",
          pattern=r"^(?P<error>\w+): (?P<said>(?:No module named|cannot import name).*?)\.?$", cause=_STOPS,
          remedy="Correct or remove that import: setup.py needs little more than setuptools, os and glob.",
          example="ModuleNotFoundError: No module named 'numpie'"),
    Known(kind="setup-py", pattern=r"^(?P<error>\w+): (?P<said>'module' object is not callable.*?)\.?$",
          cause=_STOPS,
          remedy=("The code calls a module instead of a function in it: write `from glob import glob`, "
                 "not `import glob`."),
          example="TypeError: 'module' object is not callable"),
    Known(kind="setup-py",
          pattern=r"^(?P<error>\w+): (?P<said>'(?:tuple|list)' object is not callable.*?)\.?$", cause=_STOPS,
          remedy="A comma is missing before a `(`: end each entry of a list with a comma.",
          example="TypeError: 'tuple' object is not callable"),
    Known(kind="setup-py", pattern=r"was never called",
          cause="setup.py of `{package}` never calls `setup(...)`.",
          remedy="The call belongs at the end of the file, not in a function and not under an `if`.",
          example="'distutils.core.setup()' was never called -- perhaps 'setup.py' is not a script?"),
    Known(kind="setup-py", pattern=r"^(?P<error>[A-Z]\w*): (?P<said>.*?)\.?$", cause=_STOPS,
          remedy="Run `python3 setup.py --name` in the package's folder to see the error yourself.",
          example="ValueError: odd"),
    Known(kind="entry-point", pattern=_REFUSED,
          cause="A comma is missing in setup.py of `{package}`, after the entry point on line {line}.",
          remedy=("Add one at the end of line {line}: without it, Python joins the strings on lines "
                 "{line} and {second} into one."), proof=_joined_entry,
          example="error in talk setup command: ('Invalid entry point', 'a = m:fb = m:g')",
          given={"setup.py": _JOINED}),
    Known(kind="entry-point", pattern=_REFUSED,
          cause="Line {line} of setup.py of `{package}` is not an entry point: `{seen}`.",
          remedy="An entry point names the program, the module with dots (no `/`, no `.py`), and the "
                 "function "
                 "to call: `program = package.module:function`.", proof=_unsound_entry,
          example="error in talk setup command: ('Invalid entry point', 'a = m/f.py:g')",
          given={"setup.py": _SLASH}),
    Known(kind="setup-py", pattern=_REFUSED, cause="setuptools rejects setup.py of `{package}`: {said}.",
          remedy="",
          example="error in talk setup command: 'install_requires' must be a string or list of strings"),
)  # fmt: skip
