"""Programs whose output a question asks for: really run, and compared with the choices."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Choice, Question
from course.errors import MissingHere
from course.grading.quiz.program import printed, wrong_about
from course.rosenv import find_ros

pytestmark = pytest.mark.slow


def output(tmp_path: Path, name: str, code: str) -> tuple[str, ...]:
    program = tmp_path / name
    program.write_text(code)
    return printed(program, find_ros())


def test_output_and_the_last_line_of_a_traceback(tmp_path: Path) -> None:
    code = "print(1)\nprint()\ndef f():\n    [][0]\nf()\n"
    assert output(tmp_path, "a.py", code) == ("1", "", "IndexError: list index out of range")


def test_a_node_logs_without_the_time(tmp_path: Path) -> None:
    code = "import rclpy\nrclpy.init()\nrclpy.create_node('rover').get_logger().warning('low')\n"
    assert output(tmp_path, "a.py", code) == ("[WARN] [rover]: low",)


def test_cpp_is_compiled_and_run(tmp_path: Path) -> None:
    code = "#include <iostream>\nint main()\n{\n  std::cout << __cplusplus / 100 << std::endl;\n}\n"
    assert output(tmp_path, "a.cpp", code) == ("2017",)


def test_cpp_needs_a_compiler(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("course.arena.toolchain.shutil.which", lambda *_, **__: None)
    with pytest.raises(MissingHere, match=r"needs g\+\+"):
        output(tmp_path, "a.cpp", "int main() {}")


def test_it_sees_no_file_of_the_learner_and_leaves_none(tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("mine")
    code = (
        f"cat {tmp_path}/secret 2>/dev/null || echo nothing\nls\necho $HOME > {tmp_path}/left 2>/dev/null\n"
    )
    assert output(tmp_path, "a.sh", code)[:2] == ("nothing", "a.sh")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.sh", "secret"]


RIGHT, OTHER = Choice("r", "`1`, then an `IndexError`", True), Choice("o", "`2`", False, "No.")


@pytest.mark.parametrize(
    ("choices", "lines", "said"),
    [
        ((RIGHT, OTHER), ("1", "IndexError: list index out of range"), None),
        ((RIGHT, OTHER), ("2",), "prints 2, but the right choice says: `1`, then"),
        ((Choice("n", "Nothing", True), OTHER), (), None),
        ((Choice("n", "Nothing", True), OTHER), ("",), "but the right choice says: Nothing"),
        ((RIGHT, Choice("x", "`1` `IndexError`", False)), ("1", "IndexError: x"), "what a wrong choice says"),
        ((Choice("n", "`data`", True), OTHER), ("data: 5",), "prints data: 5, but the right choice says"),
    ],
)
def test_the_right_choice_alone_says_what_is_printed(
    choices: tuple[Choice, ...], lines: tuple[str, ...], said: str | None
) -> None:
    found = wrong_about(Question("q", "?", "choice", choices), lines)
    assert found is None if said is None else said in (found or "")
