"""What remains of a recording if only one of its programs counts."""

from __future__ import annotations

import pytest

from course.evidence.recording import Recording
from course.explain.languages import Cpp, Python, language_of
from course.grading.expect.one_program import about
from course.model.events import OutputLine

from .conftest import FOLDER, log, record

SETUP = """\
setup(entry_points={'console_scripts': [
    'talker = talk.talker:main',
    'listener = talk.listener:main',
    'deaf = talk.listener:deaf',
]})
"""


def two_programs() -> Recording:
    return record(
        log(1.0, "I talk", node="talker"),
        log(2.0, "I listen", node="listener"),
        OutputLine(3.0, "listener", "printed"),
        code="TALKER",
        files={"setup.py": SETUP, "talk/listener.py": "LISTENER", "talk/words.py": "WORDS"},
    )


def texts(recording: Recording) -> list[str]:
    return [line.text for line in recording.log]


def test_the_log_is_that_of_its_node() -> None:
    assert texts(two_programs()) == ["I talk", "I listen"]
    assert texts(about(two_programs(), "talk", "listener", "listener")) == ["I listen"]


def test_what_is_not_on_rosout_stays() -> None:
    assert about(two_programs(), "talk", "talker", "talker").process("listener").text == ("printed",)


def test_modules_of_the_others_are_left_out() -> None:
    sources = about(two_programs(), "talk", "talker", "talker").sources
    assert sorted(sources.files) == [
        f"{FOLDER}/{name}" for name in ("setup.py", "talk/talker.py", "talk/words.py")
    ]


def test_a_module_that_two_programs_share_stays() -> None:
    for executable in ("listener", "deaf"):
        assert f"{FOLDER}/talk/listener.py" in about(two_programs(), "talk", executable, "deaf").sources.files


def test_all_files_stay_for_a_package_that_was_not_built() -> None:
    assert len(about(two_programs(), "walk", "walker", "walker").sources.files) == 4


LISTS = """\
add_executable(talker src/talker.cpp src/words.cpp)
add_executable(listener src/listener.cpp src/words.cpp)
install(PROGRAMS scripts/shouter.py DESTINATION lib/talk)
"""


@pytest.mark.parametrize(
    ("executable", "kept"),
    [
        ("talker", ["scripts/shouter.py", "src/talker.cpp", "src/words.cpp"]),
        ("listener", ["scripts/shouter.py", "src/listener.cpp", "src/words.cpp"]),
        ("shouter.py", ["scripts/shouter.py"]),
    ],
)
def test_sources_of_the_others_are_left_out(executable: str, kept: list[str]) -> None:
    names = ("src/talker.cpp", "src/listener.cpp", "src/words.cpp", "scripts/shouter.py")
    recording = record(files={"CMakeLists.txt": LISTS, **dict.fromkeys(names, "")})
    sources = about(recording, "talk", executable, "node").sources
    assert sorted(sources.files) == [
        f"{FOLDER}/{name}" for name in ("CMakeLists.txt", *kept, "talk/talker.py")
    ]


def test_a_script_beside_programs_in_cpp_is_spoken_of_in_python() -> None:
    recording = record(files={"CMakeLists.txt": LISTS, "src/talker.cpp": "", "scripts/shouter.py": ""})
    assert isinstance(language_of(recording.sources), Cpp)
    assert isinstance(language_of(about(recording, "talk", "talker", "talker").sources), Cpp)
    assert isinstance(language_of(about(recording, "talk", "shouter.py", "shouter").sources), Python)
