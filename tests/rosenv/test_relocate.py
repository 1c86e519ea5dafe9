from pathlib import Path

import pytest

from course.rosenv.relocate import relocate, with_includes, without_tinyxml
from tests.rosenv.made_up import EXPORT, FASTRTPS, export, wheels

INCLUDE = Path("/usr/include/python3.11")
NUMPY = Path("/home/me/venv/lib/python3.11/site-packages/numpy/_core/include")


def test_the_include_folders_become_those_of_this_machine() -> None:
    text = with_includes(EXPORT, INCLUDE, NUMPY)
    assert f'INTERFACE_INCLUDE_DIRECTORIES "{INCLUDE};{NUMPY}"' in text
    assert "/opt/python" not in text
    assert 'INTERFACE_LINK_LIBRARIES "rosidl_runtime_c;Python3::NumPy"' in text


def test_a_second_time_changes_nothing_and_a_moved_environment_is_put_right() -> None:
    once = with_includes(EXPORT, INCLUDE, NUMPY)
    assert with_includes(once, INCLUDE, NUMPY) == once
    moved = Path("/elsewhere/numpy/_core/include")
    assert str(NUMPY) not in with_includes(once, INCLUDE, moved)
    assert f'"{INCLUDE};{moved}"' in with_includes(once, INCLUDE, moved)


def test_signs_that_cmake_would_interpret_are_escaped() -> None:
    text = with_includes(EXPORT, Path('/a$b"c/include/python3.11'), NUMPY)
    assert r'"/a\$b\"c/include/python3.11;' in text


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (FASTRTPS, FASTRTPS.replace("/usr/lib64/libtinyxml2.so;", "")),
        ('"a;/usr/lib64/libtinyxml2.so"', '"a"'),
        ('"/usr/lib64/libtinyxml2.so;b"', '"b"'),
        ('"/usr/lib64/libtinyxml2.so"', '""'),
        ('"a;/usr/lib64/libtinyxml2.so.9;b"', '"a;/usr/lib64/libtinyxml2.so.9;b"'),
    ],
)
def test_tinyxml_goes_wherever_it_stands_in_the_list(text: str, expected: str) -> None:
    assert without_tinyxml(text) == expected
    assert without_tinyxml(expected) == expected


def test_all_files_that_need_it_are_corrected_once(tmp_path: Path) -> None:
    wheels(tmp_path)
    other = tmp_path / "share/geometry_msgs/cmake/other.cmake"
    other.write_text(EXPORT)
    changed = relocate(tmp_path, INCLUDE, NUMPY)
    assert {file.name for file in changed} == {
        export(tmp_path, "geometry_msgs").name,
        export(tmp_path, "std_msgs").name,
        "fastrtps-shared-targets.cmake",
    }
    assert other.read_text() == EXPORT
    assert relocate(tmp_path, INCLUDE, NUMPY) == ()


def test_a_try_that_was_killed_halfway_is_finished(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    wheels(tmp_path)
    replace = Path.replace
    done: list[Path] = []

    def killed_at_the_second(self: Path, target: Path) -> Path:
        if done:
            raise KeyboardInterrupt
        done.append(target)
        return replace(self, target)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", killed_at_the_second)
        with pytest.raises(KeyboardInterrupt):
            relocate(tmp_path, INCLUDE, NUMPY)
    left = export(tmp_path, "std_msgs").with_name(f".{export(tmp_path, 'std_msgs').name}.ros2course-12")
    left.write_text("half of a fi")
    assert len(relocate(tmp_path, INCLUDE, NUMPY)) == 2
    assert not left.exists()
    assert relocate(tmp_path, INCLUDE, NUMPY) == ()


def test_a_prefix_without_such_files_is_left_alone(tmp_path: Path) -> None:
    assert relocate(tmp_path, INCLUDE, NUMPY) == ()
    assert not list(tmp_path.iterdir())
