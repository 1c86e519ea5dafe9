""""""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NoReturn

import pytest

from course.errors import StorageError
from course.files import locked
from course.rosenv import node_environment, preparation, prepare, setup_script
from course.rosenv.host import Host
from course.rosenv.preparation import relocate, with_includes, without_tinyxml
from tests.rosenv.made_up import (
    EXPORT,
    FASTRTPS,
    VERSION,
    export,
    installed,
    no_wheels,
    pip_ros,
    wheels,
    write,
)


def forbidden(*_: object, **__: object) -> NoReturn:
    raise AssertionError("this was not to be called")


def contents(folder: Path) -> dict[str, int]:
    """Every path below a folder, with what changes when it is replaced."""
    return {str(path): path.lstat().st_ino for path in folder.rglob("*")}


def test_wheels_are_corrected_and_get_their_setup_files(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    prepare(ros, {"HOME": str(tmp_path)})
    text = export(ros.prefix, "geometry_msgs").read_text()
    assert "/opt/python" not in text
    assert f"{ros.prefix}/lib/python3.11/site-packages/numpy/_core/include" in text
    assert setup_script(ros, {"HOME": str(tmp_path)}) == ros.prefix / "setup.bash"
    for name in ("setup", "local_setup"):
        assert all((ros.prefix / f"{name}.{shell}").is_file() for shell in ("sh", "bash", "zsh"))


def test_with_nothing_to_do_nothing_is_locked_or_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    prepare(ros, {"HOME": str(tmp_path)})
    before = contents(tmp_path)
    monkeypatch.setattr(preparation, "locked", forbidden)
    prepare(ros, {"HOME": str(tmp_path)})
    assert contents(tmp_path) == before


def test_a_wheel_that_pip_put_there_again_is_corrected_again(tmp_path: Path) -> None:
    host = wheels(tmp_path / "venv")
    prepare(pip_ros(host), {"HOME": str(tmp_path)})
    export(host.prefix, "std_msgs").write_text(EXPORT)
    os.utime(host.site_packages / "ros_rclpy-7.1.6.dist-info", (1, 1))
    prepare(pip_ros(host), {"HOME": str(tmp_path)})
    assert "/opt/python" not in export(host.prefix, "std_msgs").read_text()


def test_a_new_library_folder_gets_into_the_setup_files(tmp_path: Path) -> None:
    host = wheels(tmp_path / "venv")
    prepare(pip_ros(host), {"HOME": str(tmp_path)})
    (host.site_packages / "ros_new-1.0.dist-info").mkdir()
    (host.site_packages / "ros_new.libs").mkdir()
    prepare(pip_ros(host), {"HOME": str(tmp_path)})
    assert "ros_new.libs" in (host.prefix / "local_setup.sh").read_text()


def test_setup_files_that_somebody_removed_come_back(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    prepare(ros, {"HOME": str(tmp_path)})
    (ros.prefix / "local_setup.sh").unlink()
    prepare(ros, {"HOME": str(tmp_path)})
    assert (ros.prefix / "local_setup.sh").exists()


@pytest.mark.parametrize("damage", [b"", b"\xff\xfe", b"something else\n"])
def test_a_damaged_stamp_is_made_anew(tmp_path: Path, damage: bytes) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    prepare(ros, {"HOME": str(tmp_path)})
    stamp = ros.prefix / "share/ros2course/prepared"
    good = stamp.read_bytes()
    stamp.write_bytes(damage)
    prepare(ros, {"HOME": str(tmp_path)})
    assert stamp.read_bytes() == good


def test_an_interrupted_try_is_not_taken_for_done(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))

    def interrupted(*_: object) -> NoReturn:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(preparation, "write_setup_files", interrupted)
        with pytest.raises(KeyboardInterrupt):
            prepare(ros, {"HOME": str(tmp_path)})
    assert not (ros.prefix / "setup.bash").exists()
    prepare(ros, {"HOME": str(tmp_path)})
    assert (ros.prefix / "setup.bash").exists()


def test_who_waited_for_another_process_does_nothing_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))

    @contextmanager
    def after_another(path: Path) -> Iterator[None]:
        with monkeypatch.context() as patch:
            patch.setattr(preparation, "locked", locked)
            prepare(ros, {"HOME": str(tmp_path)})
        monkeypatch.setattr(preparation, "relocate", forbidden)
        yield

    monkeypatch.setattr(preparation, "locked", after_another)
    prepare(ros, {"HOME": str(tmp_path)})
    assert (ros.prefix / "setup.bash").exists()


def test_several_processes_at_once_leave_one_right_result(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    code = (
        "import sys; from pathlib import Path; from course.rosenv import Ros, prepare;"
        "p = Path(sys.argv[1]); sys.stdin.read();"
        "prepare(Ros('pip', 'jazzy', p, p / 'bin/python3', sys.argv[2]), {'HOME': sys.argv[3]})"
    )
    command = [sys.executable, "-c", code, str(ros.prefix), ros.identity, str(tmp_path)]
    environ = {**os.environ, "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1"}
    processes = [
        subprocess.Popen(command, stdin=subprocess.PIPE, env=environ, cwd=Path(__file__).parents[2])
        for _ in range(3)
    ]
    # All wait for their input to end, and so begin together.
    for process in processes:
        process.stdin.close()
    assert [process.wait(30) for process in processes] == [0, 0, 0]
    assert "/opt/python" not in export(ros.prefix, "geometry_msgs").read_text()
    assert not list(ros.prefix.rglob(".*ros2course-*"))


@pytest.fixture
def read_only(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A prefix that this user may not write to; who is root may do anything, so for root it only looks so."""
    prefix = wheels(tmp_path / "venv").prefix
    allowed = os.access
    monkeypatch.setattr(
        os, "access", lambda path, mode: not Path(path).is_relative_to(prefix) and allowed(path, mode)
    )
    folders = [prefix, *(path for path in prefix.rglob("*") if path.is_dir())]
    for folder in folders:
        folder.chmod(0o555)
    yield prefix
    for folder in folders:
        folder.chmod(0o755)


def test_setup_files_for_a_prefix_of_somebody_else_go_into_the_cache(
    tmp_path: Path, read_only: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    environ = {"ROS2COURSE_CACHE": str(tmp_path / "cache")}
    packages = read_only / "lib/python3.11/site-packages"
    ros = pip_ros(Host(read_only / "bin/python3", read_only, packages, VERSION))
    monkeypatch.setattr(preparation, "relocate", lambda *_: ())  # its owner did that
    before = contents(read_only)
    prepare(ros, environ)
    assert contents(read_only) == before
    assert setup_script(ros, environ).is_relative_to(tmp_path / "cache")
    assert setup_script(ros, environ).is_file()
    profile = Path(node_environment(ros, environ=environ)["FASTRTPS_DEFAULT_PROFILES_FILE"])
    assert profile.is_relative_to(tmp_path / "cache")


def test_setup_files_that_the_owner_wrote_are_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    environ = {"ROS2COURSE_CACHE": str(tmp_path / "cache")}
    prepare(ros, environ)
    monkeypatch.setattr(os, "access", lambda *_: False)
    prepare(ros, environ)
    assert setup_script(ros, environ) == ros.prefix / "setup.bash"
    assert not (tmp_path / "cache").exists()


def test_what_cannot_be_written_is_said(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    write(ros.prefix / "share/ros2course", "a file where our folder should be")
    with pytest.raises(StorageError) as caught:
        prepare(ros, {"HOME": str(tmp_path)})
    assert "share/ros2course" in caught.value.what
    assert "disk is full" in (caught.value.next_step or "")


def test_numpy_may_lie_in_the_python_beneath_and_may_be_old(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    packages = ros.python_packages
    (packages / "numpy/_core").rename(packages / "numpy/core")
    prepare(ros, {"HOME": str(tmp_path)})
    assert f"{packages}/numpy/core/include" in export(ros.prefix, "std_msgs").read_text()
    (packages / "numpy").rename(packages / "gone")
    (ros.prefix / "local_setup.sh").unlink()
    prepare(ros, {"HOME": str(tmp_path)})
    assert str(packages) not in export(ros.prefix, "std_msgs").read_text()
    assert "numpy/_core/include" in export(ros.prefix, "std_msgs").read_text()


def test_an_installed_ros_is_left_alone(tmp_path: Path) -> None:
    host = no_wheels(tmp_path)
    installed(host.installed)
    ros = pip_ros(host)
    before = contents(tmp_path)
    prepare(ros, {"HOME": str(tmp_path)})
    assert contents(tmp_path) == before


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
    left = export(tmp_path, "std_msgs").with_name(
        f".{export(tmp_path, 'std_msgs').name}.99999999-77aa.ros2course-part"
    )
    left.write_text("half of a fi")
    assert len(relocate(tmp_path, INCLUDE, NUMPY)) == 2
    assert not left.exists()
    assert relocate(tmp_path, INCLUDE, NUMPY) == ()


def test_a_prefix_without_such_files_is_left_alone(tmp_path: Path) -> None:
    assert relocate(tmp_path, INCLUDE, NUMPY) == ()
    assert not list(tmp_path.iterdir())
