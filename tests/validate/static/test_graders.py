"""Grader modules: what they declare is read, and they are loaded."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from course.validate.static import graders
from course.validate.static.graders import declarations

from .conftest import GRADER, Change, Tell

NAME = "graders/ch04_lanterns.py"


def test_a_syntax_error(change: Change, tell: Tell) -> None:
    change(NAME, "def there(recording: Recording) -> None:", "def there(recording: Recording) -> None")
    assert tell() == [f"{NAME}:16: the grader is not valid Python: expected ':'"]


def test_a_module_that_is_not_there(change: Change, tell: Tell) -> None:
    change(NAME, "from course.api import Grader", "import lanterns_for_all\nfrom course.api import Grader")
    what = "the grader cannot be loaded: ModuleNotFoundError: No module named 'lanterns_for_all'"
    assert tell() == [f"{NAME}:4: {what}"]


@pytest.mark.parametrize("line", ["raise SystemExit(3)", "1 / 0", "raise KeyError"])
def test_a_module_that_stops(line: str, change: Change, tell: Tell) -> None:
    change(NAME, "light = ", f"{line}\nlight = ")
    (told,) = tell()
    assert told.startswith(f"{NAME}:6: the grader cannot be loaded: ")


def test_a_module_that_never_ends(change: Change, tell: Tell, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(graders, "LOAD_TIME", 0.3)
    change(NAME, "light = ", "while True:\n    pass\nlight = ")
    (told,) = tell()
    assert told.startswith((f"{NAME}:6: ", f"{NAME}:7: "))  # the loop, or what it repeats
    assert told.endswith("the grader cannot be loaded: importing it did not end within 0.3 s")


@pytest.mark.parametrize("points", ["0", "-2", "float('nan')"])
def test_a_check_that_is_worth_nothing(points: str, change: Change, tell: Tell) -> None:
    change(NAME, '"it is bright")', f'"it is bright", points={points})')
    (told,) = tell()
    assert told.startswith(f"{NAME}:10: the grader cannot be loaded: check is_bright of 04-light is worth")


def test_bytes_that_are_no_module(root: Path, tell: Tell) -> None:
    (root / NAME).write_bytes(b"\xff\xfe\x00grader")
    (told,) = tell()
    assert told.startswith(f"{NAME}:") and "the grader " in told


def test_all_wrong_declarations_of_a_module(change: Change, tell: Tell) -> None:
    change(NAME, 'needs="there"', 'needs=("herre", "there")')
    change(
        NAME, 'light.check("is_bright", "it is bright")', 'light.check("is_bright", "b", needs="is_bright")'
    )
    change(
        NAME, "@dim.check", '@dim.check("there", "first")\ndef first(recording):\n    pass\n\n\n@dim.check'
    )
    assert tell() == [
        f"{NAME}:10: check `is_bright` needs itself: is_bright -> is_bright",
        f"{NAME}:20: 04-dim has two checks `there`; the first is on line 15",
        f"{NAME}:25: check `dims` needs `herre`, which is not a check; did you mean `there`?",
    ]


def test_a_circle_of_checks_is_told_once(change: Change, tell: Tell) -> None:
    change(NAME, '"the file is there")', '"the file is there", needs=["dims"])')
    assert tell() == [f"{NAME}:20: check `dims` needs itself: dims -> there -> dims"]


def test_a_check_that_stands_too_late(change: Change, tell: Tell) -> None:
    late = '\n\n@dim.check("late", "late")\ndef late(recording: Recording) -> None:\n    pass\n'
    change(NAME, "", GRADER.replace('needs="there"', 'needs="late"') + late)
    assert tell() == [f"{NAME}:20: check `dims` needs `late`, which is only on line 25"]


def test_two_scenarios_are_a_fault_of_loading(change: Change, tell: Tell) -> None:
    change(NAME, "", GRADER + "\n\nlight.scenario(is_bright)\nlight.scenario(there)\n")
    assert tell() == [f"{NAME}:26: the grader cannot be loaded: 04-light has two scenarios"]


def test_an_exercise_without_a_grader(change: Change, tell: Tell) -> None:
    change(NAME, 'light = Grader("04-light"', 'light = Grader("04-ligth"')
    assert tell() == [
        "chapters/04-lanterns/lesson.yaml:5: ch04_lanterns.py has no `Grader` of 04-light",
        f"{NAME}:6: `Grader` of `04-ligth`, which its chapter does not have; did you mean `04-light`?",
    ]


def test_two_graders_of_one_exercise(change: Change, tell: Tell) -> None:
    change(NAME, "dim = ", 'again = Grader("04-light", builds=None)\ndim = ')
    assert tell() == [f"{NAME}:6: 04-light has 2 of `Grader`, and only the first is used"]


def test_what_is_declared_is_read() -> None:
    source = (
        'ID = "far"\n'
        'g = Grader("04-x")\n'
        "for name in NAMES:\n    g.check(name, name)(partial(look, name))\n"
        'g.check(ID, "t", needs=BUILDS)(look)\n'
        "@g.check('kind', 'k', needs=())\ndef kind(r):\n    raise NotApplicable('no')\n"
        "@g.check('strict', 's', needs=other)\ndef strict(r):\n    helper(r)\n"
        "    raise NotApplicable('no')\n"
    )
    (found,) = declarations(ast.parse(source))
    assert (found.exercise, found.line, found.builds, found.whole) == ("04-x", 2, True, False)
    assert [(c.id, c.line, c.needs, c.can_fail) for c in found.checks] == [
        ("far", 5, ("builds",), True),
        ("kind", 6, (), False),
        ("strict", 9, None, True),
    ]


WRITE = """
(arena.home / 'file').write_text('text')
arena.home.joinpath('file').write_bytes(b'')
(arena.home / 'folder').mkdir(parents=True)
file.unlink(missing_ok=True)
file.rename(other)
file.replace(other)
file.symlink_to(other)
file.touch()
file.chmod(0o755)
file.open('w')
file.open(mode='a')
open(file, 'r+b')
open(file, mode)
io.open(file, 'x')
gzip.open(file, mode='wb')
Path.replace(here, there)
[*map(Path.unlink, [file])]
shutil.rmtree(arena.home / 'folder')
copytree(here, there)
remove_all(there)
shutil.unpack_archive(file, there)
zipfile.ZipFile(file).extractall(there)
archive.extractall(there)
archive.extract(other, there)
zipfile.ZipFile(file, 'w')
tarfile.open(file, 'w:gz')
os.replace(here, there)
os.open(file, mode)
os.symlink(here, there)
os.link(here, there)
os.rename(here, there)
os.mkdir(there)
os.makedirs(there)
[*map(os.unlink, [file])]
tempfile.mkdtemp()
"""
START = """
subprocess.run(['cp', here, there])
subprocess.check_call(['cp', here, there])
subprocess.Popen(['cp', here, there])
start(['cp', here, there])
partial(start, 'true')
os.system('true')
os.popen('true')
os.execvp('true', ['true'])
os.spawnlp(mode, 'true', 'true')
os.posix_spawn('/bin/true', ['true'], {})
asyncio.create_subprocess_exec('true')
asyncio.subprocess.create_subprocess_shell('true')
"""
READ = """
file.read_text()
Path.read_text(file)
file.open()
open(file, 'rb')
shutil.which('cmake')
'text'.replace('t', 'x')
dataclasses.replace(file, name='')
os.path.join(file, file)
zipfile.ZipFile(file).read('x')
tarfile.open('waxed.tar', 'r:xz')
tarfile.open(file).extractfile('x')
file.run('cp')
print(mode, subprocess.PIPE)
"""


@pytest.mark.parametrize(
    ("lines", "words"),
    [(WRITE, "writes a file,"), (START, "starts a program with all permissions,"), (READ, None)],
    ids=["writing", "starting", "reading"],
)
def test_a_grader_neither_writes_nor_starts_programs(
    lines: str, words: str | None, root: Path, tell: Tell
) -> None:
    acts = lines.strip().splitlines()
    imports = """import asyncio, dataclasses, gzip, io, os, shutil, subprocess, tarfile, tempfile, zipfile
from functools import partial
from pathlib import Path
from shutil import copytree, rmtree as remove_all
from subprocess import run as start
"""
    function = "def act(arena, archive, file, here, mode, other, there):"
    text = "\n    ".join([imports + GRADER + function, *acts])
    (root / NAME).write_text(text)
    first = text.splitlines().index(function) + 2
    found = tell()
    told = [line.split()[0] for line in found if words and words in line]
    wanted = [f"{NAME}:{number}:" for number, _ in enumerate(acts, first) if words]
    assert (told, len(found)) == (wanted, len(wanted)), found


def test_only_archives_are_known_to_extract_files(change: Change, tell: Tell) -> None:
    change(NAME, "\n\n@light", "\n\ndef act(words):\n    words.extract(0)\n\n\n@light")
    assert tell() == []


def test_probes_run_with_the_rights_of_the_submission(change: Change, tell: Tell) -> None:
    for name in ("graders/probes/ch04_dim.py", "graders/lib/dim.py"):
        change(name, "", "open('dim.txt', 'w')\n")
    (told,) = (told for told in tell() if "writes a file" in told)
    assert told.startswith("graders/lib/dim.py:1: `open`")


@pytest.mark.parametrize(
    ("line", "named"),
    [
        ("from course.evidence.recording import Recording", "course.evidence.recording"),
        ("import course.grading.author", "course.grading.author"),
        ("from course import grading", "course.grading"),
        ("if True:\n    from course.model import replace", "course.model"),
    ],
)
def test_a_grader_imports_of_the_engine_its_api_alone(
    line: str, named: str, change: Change, tell: Tell
) -> None:
    change("graders/lib/__init__.py", "", "")
    change("graders/lib/shared.py", "", f"{line}\nfrom course import api\nimport course.api\n")
    change(NAME, "from course.api", "from lib import shared\nfrom course.api")
    number = 2 if line.startswith("if") else 1
    what = f"imports `{named}`, which is not meant for graders and may change"
    assert tell() == [f"graders/lib/shared.py:{number}: {what}"]
