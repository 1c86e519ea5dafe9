"""Scripts of the course home, and probes of the code in it."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.errors import OurFault
from course.evidence.process_view import ProbeView
from course.model.events import ProgramMissing
from lib.lint import UNREADABLE, findings

from .conftest import WAIT
from .programs import Programs

SCRIPT = "#!/usr/bin/env python3\nimport os, sys\nprint(os.getcwd(), os.environ['HOME'], sys.argv[1:])\n"


def test_a_script_runs_in_its_own_folder(programs: Programs) -> None:
    programs.write("python/talk.py", SCRIPT)
    program = programs.python("python/talk.py", "a", "b c")
    assert program is not None and program.wait(WAIT)
    assert programs.recording.process("talk.py").text == ("~/python ~ ['a', 'b c']",)


def test_another_name_and_environment(programs: Programs) -> None:
    programs.write("there/talk", "#!/bin/sh\necho $PWD $EXTRA\n", 0o755)
    program = programs.execute("there/talk", name="it", env={"EXTRA": "1"})
    assert program is not None and program.wait(WAIT)
    assert programs.recording.process("it").text == ("~/there 1",)


def test_direct_execution_goes_by_mode_and_first_line(programs: Programs) -> None:
    programs.write("python/talk", "#!/bin/sh\necho from sh $1\n", 0o755)
    programs.write("python/closed", "#!/bin/sh\necho never\n", 0o644)
    for name in ("talk", "closed"):
        program = programs.execute(f"python/{name}", "x")
        assert program is not None and program.wait(WAIT)
    assert programs.recording.process("talk").text == ("from sh x",)
    closed = programs.recording.process("closed")
    assert closed.exited is not None and closed.exited.code == 126
    assert "Permission denied" in closed.text[0]


def test_a_file_that_is_not_there_is_recorded(programs: Programs) -> None:
    programs.write("folder/x", "")
    assert programs.python("talk.py") is None
    assert programs.execute("folder") is None
    assert [lost.file for lost in programs.timeline.of(ProgramMissing)] == ["talk.py", "folder"]
    lost = programs.recording.missing_program("talk.py")
    assert lost is not None and lost.file == "talk.py"


@pytest.mark.parametrize("file", ["../x.py", "/etc/passwd", "a/../../x"])
def test_a_scenario_stays_in_the_home(programs: Programs, file: str) -> None:
    with pytest.raises(OurFault, match="leaves the course home"):
        programs.python(file)


# probes


def probe(programs: Programs, code: str, **more: float) -> ProbeView:
    programs.probe(code, cwd="project", **more)  # type: ignore[arg-type]
    return programs.recording.probe()


def test_questions_and_answers(programs: Programs) -> None:
    programs.write(
        "project/theirs/__init__.py", 'print(\'{"question": "sum", "value": 0}\')\nclass Odd: pass\n'
    )
    code = """
import theirs
ask("sum", lambda: 1 + 2)
ask("data", lambda: {"a": [1.5, None, (True, "x")]})
ask("odd", theirs.Odd)
"""
    found = probe(programs, code)
    assert found.finished and found.broken is None
    sum_, data, odd = (found.answer(name) for name in ("sum", "data", "odd"))
    assert sum_ is not None and (sum_.value, sum_.type) == (3, "int")
    assert data is not None and data.value == {"a": [1.5, None, [True, "x"]]}
    assert odd is not None and odd.type == "Odd" and "Odd object" in odd.value
    assert len(found.answers) == 3


def test_an_exception_has_the_learners_line_and_ends_one_question(programs: Programs) -> None:
    code = "import json\ndef f():\n    return json.loads('{')\ndef outer():\n    return f()\n"
    programs.write("project/theirs.py", code)
    found = probe(programs, "import theirs\nask('f', theirs.outer)\nask('next', lambda: 1)\n")
    answer = found.answer("f")
    assert answer is not None and answer.error is not None
    assert answer.error.startswith("json.decoder.JSONDecodeError")
    assert (answer.file, answer.line) == ("project/theirs.py", 3)
    assert found.answer("next") is not None


@pytest.mark.parametrize(
    ("code", "error", "line"),
    [
        ("def f(:\n", "SyntaxError", 1),
        ("x = 1\nraise SystemExit(0)\n", "SystemExit", 2),
        ("\n\nimport lost\n", "ModuleNotFoundError", 3),
    ],
)
def test_code_that_cannot_be_imported(programs: Programs, code: str, error: str, line: int) -> None:
    programs.write("project/theirs.py", code)
    found = probe(programs, "import theirs\nask('f', theirs.f)\n")
    assert found.finished and found.broken is not None
    assert error in (found.broken.error or "")
    assert (found.broken.file, found.broken.line) == ("project/theirs.py", line)


@pytest.mark.slow
def test_code_that_hangs_or_leaves(programs: Programs) -> None:
    programs.write("project/theirs.py", "import os, time\ndef hang():\n    time.sleep(1000)\n")
    found = probe(programs, "import theirs\nask('a', lambda: 1)\nask('b', theirs.hang)\n", timeout=2.0)
    assert not found.finished
    assert [answer.question for answer in found.answers] == ["a"]
    programs.probe("import os\nask('a', lambda: 1)\nos._exit(0)\n", name="left", cwd="project")
    assert not programs.recording.probe("left").finished


def test_a_probe_that_does_not_start_is_our_fault(
    programs: Programs, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(programs, "_python", "/bin/false")
    with pytest.raises(OurFault, match="did not start"):
        programs.probe("", name="lost")


@pytest.mark.slow
def test_threads_left_behind_do_not_keep_it(programs: Programs) -> None:
    programs.write("project/x", "")
    code = (
        "import threading, time\nthreading.Thread(target=time.sleep, args=(1000,)).start()\nask('a', int)\n"
    )
    assert probe(programs, code).finished


def test_a_probe_in_a_file_and_one_without_its_folder(programs: Programs, tmp_path: Path) -> None:
    (tmp_path / "ours.py").write_text("ask('a', lambda: 1)\n")
    programs.probe(tmp_path / "ours.py")
    assert programs.recording.probe().finished
    programs.probe("ask('a', int)", name="lost", cwd="nowhere")
    assert not programs.recording.probe("lost").ran
    assert programs.recording.missing_program("lost") is not None


def test_what_is_no_answer_of_ours_is_left_out(programs: Programs) -> None:
    programs.write("project/x", "")
    code = """
import os
deep, half = '[' * 50 + ']' * 50, chr(92) + 'ud800'
forged = ['"other": 1', '"error": []', '"type": {}', '"file": 7', '"line": "x"']
forged += [f'"value": {deep}', f'"error": "{half}"']
others = [f'{{"question": "a", {field}}}' for field in forged]
for text in ('nonsense', '[1]', '{"question": 1}', '{}', '[' * 100000, *others):
    os.write(int(open('/proc/self/cmdline').read().split(chr(0))[2]), (text + chr(10)).encode())
ask('real', lambda: 1)
"""
    assert [answer.question for answer in probe(programs, code).answers] == ["real"]


def test_half_a_character_in_an_answer_is_replaced(programs: Programs) -> None:
    programs.write("project/x", "")
    found = probe(programs, "ask('half', lambda: chr(0xd800) + ' a')\n").answer("half")
    assert found.value == "? a"


# other programs


def test_a_module_is_run_from_a_folder(programs: Programs) -> None:
    programs.write("project/theirs/talk.py", "import sys\nprint(sys.argv[1:], sys.path[0])\n")
    program = programs.python_module("theirs.talk", "x", name="it", cwd="project")
    assert program is not None and program.wait(WAIT)
    assert programs.recording.process("it").text == ("['x'] ~/project",)
    assert programs.python_module("theirs.talk", cwd="nowhere") is None
    assert programs.recording.missing_program("theirs.talk") is not None


def test_a_program_of_the_learners_own_home(tmp_path: Path) -> None:
    own = tmp_path / "own"
    (own / "tools").mkdir(parents=True)
    (own / "tools/where").write_text('#!/bin/sh\necho "$0"; pwd; echo "$KIND"\n')
    (own / "tools/where").chmod(0o755)
    programs = Programs(tmp_path, own)
    program = programs.in_place("tools/where", name="it")
    assert program is not None and program.wait(WAIT)
    assert programs.recording.process("it").text == (f"{own}/tools/where", str(programs.home), "plain")
    assert programs.in_place("tools/lost", name="lost") is None
    assert programs.recording.missing_program("lost") is not None
    programs.close()


CODE = '"""A module."""\n\n\nclass bad:\n    def method(self):  # noqa\n        return 1\n'


def test_the_linter_names_rules_files_and_lines(programs: Programs) -> None:
    programs.write("project/theirs/_hidden.py", CODE)
    programs.write("project/theirs/open.py", CODE)
    programs.write("project/pyproject.toml", '[tool.ruff]\nexclude = ["*"]\n')
    programs.lint("project/theirs", "N801", "D102")
    assert [(one.rule, str(one.where)) for one in findings(programs.recording)] == [
        ("N801", "project/theirs/_hidden.py:4"),
        ("D102", "project/theirs/_hidden.py:5"),
        ("N801", "project/theirs/open.py:4"),
        ("D102", "project/theirs/open.py:5"),
    ]
    assert sorted(path.name for path in (programs.home / "project/theirs").iterdir()) == [
        "_hidden.py",
        "open.py",
    ]


def test_the_linter_on_code_that_cannot_be_read(programs: Programs) -> None:
    programs.write("project/theirs.py", "def f(:\n")
    programs.lint("project", "N801")
    (broken,) = findings(programs.recording, UNREADABLE)[:1]
    assert str(broken.where) == "project/theirs.py:1"
    assert findings(programs.recording, "N") == ()


def test_a_linter_that_fails_is_our_fault(programs: Programs) -> None:
    programs.write("project/theirs.py", "")
    programs.lint("project", "NO_SUCH_RULE")
    with pytest.raises(OurFault, match="linter"):
        findings(programs.recording)
