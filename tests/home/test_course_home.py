"""Making a course home, and completing one."""

from __future__ import annotations

import json
import multiprocessing
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest

from course.errors import StorageError, UsageError
from course.home import CourseHome, create_home, find_home, is_home, remember_course, remembered_course

ALL = {
    ".",
    ".bashrc",
    ".ros2course",
    ".ros2course/home.json",
    "cmake_tutorial",
    "ros2_tutorial_workspace/src",
    "ros2_tutorials_preamble/python",
    "sas_tutorial_workspace",
}


def made(path: Path) -> set[str]:
    before = there(path)
    create_home(path)
    return {name for name, _ in there(path) - before}


def there(path: Path) -> set[tuple[str, int]]:
    """Of what a home consists of, what exists: names and inodes."""
    return {(name, (path / name).stat().st_ino) for name in ALL if (path / name).exists()}


def test_everything_is_made(tmp_path: Path) -> None:
    path = tmp_path / "deep/home"
    assert made(path) == ALL
    assert all((path / name).exists() for name in ALL)
    assert is_home(path)


def test_the_paths_of_a_home(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    assert home.state == tmp_path / "home/.ros2course"
    assert home.workspace == tmp_path / "home/ros2_tutorial_workspace"


def test_a_relative_path_is_made_absolute(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert create_home(Path("a/../home")).path == tmp_path / "home"


def test_a_second_time_nothing_is_made_and_nothing_changed(tmp_path: Path) -> None:
    first = create_home(tmp_path / "home")
    seed = first.seed()
    (first.path / ".bashrc").write_text("mine\n")
    assert made(first.path) == set()
    assert first.seed() == seed
    assert (first.path / ".bashrc").read_text() == "mine\n"


def test_what_is_missing_is_completed(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    (home.path / ".bashrc").unlink()
    (home.path / "cmake_tutorial").rmdir()
    assert made(home.path) == {".bashrc", "cmake_tutorial"}


def test_a_folder_with_files_may_become_a_home(tmp_path: Path) -> None:
    (tmp_path / "home/ros2_tutorial_workspace/src/mine").mkdir(parents=True)
    assert "ros2_tutorial_workspace/src" not in made(tmp_path / "home")
    assert (tmp_path / "home/ros2_tutorial_workspace/src/mine").is_dir()


def test_seeds_differ(tmp_path: Path) -> None:
    seeds = {create_home(tmp_path / str(number)).seed() for number in range(3)}
    assert len(seeds) == 3
    assert all(0 <= seed < 2**63 for seed in seeds)


def test_the_bashrc_is_short_and_names_no_ros(home: CourseHome) -> None:
    text = (home.path / ".bashrc").read_text()
    assert len(text.splitlines()) < 10
    assert "source" not in text


def test_a_file_is_no_place(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(UsageError, match="is a file"):
        create_home(tmp_path / "file")


def test_the_user_s_own_home_is_left_alone(guarded_home: Path) -> None:
    with pytest.raises(UsageError, match="your own home") as caught:
        create_home(guarded_home)
    assert str(guarded_home / "ros2course") in (caught.value.next_step or "")
    assert not list(guarded_home.iterdir())


def test_in_the_course_s_own_shell_the_home_can_be_completed(
    home: CourseHome, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", str(home.path))
    assert create_home(home.path) == home


DAMAGED = ("", "{", "[]", '{"schema": 1}', '{"schema": 1, "seed": null}', "\0")
# Valid JSON that Python cannot represent or read.
UNREADABLE = ('{"schema": 1, "seed": 1e999}', '{"schema": 1, "seed": NaN}', "[" * 200_000)


@pytest.mark.parametrize("content", [*DAMAGED, *UNREADABLE], ids=range(9))
def test_a_damaged_marker_is_told_and_made_anew(home: CourseHome, content: str) -> None:
    marker = home.state / "home.json"
    marker.write_text(content)
    with pytest.raises(StorageError, match="is damaged") as caught:
        home.seed()
    assert "ros2course init" in (caught.value.next_step or "")
    assert made(home.path) == {".ros2course/home.json"}
    assert home.seed() >= 0
    (aside,) = home.state.glob("home.damaged-*.json")
    assert aside.read_text() == content


def test_a_home_of_a_newer_version_is_left_alone(home: CourseHome) -> None:
    marker = home.state / "home.json"
    marker.write_text(json.dumps({"schema": 99, "seed": 5}))
    (home.path / "cmake_tutorial").rmdir()
    for attempt in (home.seed, lambda: create_home(home.path)):
        with pytest.raises(UsageError, match="newer") as caught:
            attempt()
        assert "upgrade" in (caught.value.next_step or "")
    assert json.loads(marker.read_text())["seed"] == 5
    assert not (home.path / "cmake_tutorial").exists()


def test_a_folder_where_a_file_stands_is_told(tmp_path: Path) -> None:
    (tmp_path / "home").mkdir()
    (tmp_path / "home/cmake_tutorial").write_text("mine")
    with pytest.raises(StorageError, match="cmake_tutorial"):
        create_home(tmp_path / "home")
    assert (tmp_path / "home/cmake_tutorial").read_text() == "mine"
    assert not is_home(tmp_path / "home")


def test_a_link_that_leads_out_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "home").mkdir()
    (tmp_path / "home/ros2_tutorials_preamble").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(UsageError, match="ros2_tutorials_preamble is a link that leads out"):
        create_home(tmp_path / "home")
    assert not list((tmp_path / "elsewhere").iterdir())


def test_a_state_folder_that_leads_out_is_not_written(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "home").mkdir()
    (tmp_path / "home/.ros2course").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(UsageError, match="leads out"):
        create_home(tmp_path / "home")
    assert not list((tmp_path / "elsewhere").iterdir())


def test_a_read_only_place_is_told(
    open_folder: Path, read_only: Callable[[Path], AbstractContextManager[None]]
) -> None:
    with read_only(open_folder), pytest.raises(StorageError, match="cannot be created") as caught:
        create_home(open_folder / "home")
    assert "choose another folder" in (caught.value.next_step or "")


@pytest.mark.slow
def test_two_at_once_agree_on_one_seed(tmp_path: Path) -> None:
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        seeds = pool.map(_seed_of_new_home, [tmp_path / "home"] * 4, chunksize=1)
    assert len(set(seeds)) == 1


def _seed_of_new_home(path: Path) -> int:
    return create_home(path).seed()


@pytest.fixture
def user(tmp_path: Path) -> Path:
    """A user's own home, with the usual course home in it."""
    create_home(tmp_path / "user/ros2course")
    return tmp_path / "user"


def test_an_option_goes_before_all(tmp_path: Path, user: Path) -> None:
    wanted = create_home(tmp_path / "wanted")
    environ = {"HOME": str(user), "ROS2COURSE_HOME": str(user / "ros2course")}
    assert find_home(wanted.path, environ, user / "ros2course") == wanted


def test_an_option_may_be_relative_or_begin_with_a_tilde(tmp_path: Path, user: Path) -> None:
    wanted = create_home(tmp_path / "wanted")
    assert find_home(Path("../wanted"), {}, user) == wanted
    assert find_home(Path("~/ros2course"), {"HOME": str(user)}, tmp_path).path == user / "ros2course"


def test_the_variable_goes_before_the_folder(tmp_path: Path, user: Path) -> None:
    wanted, other = create_home(tmp_path / "wanted"), create_home(tmp_path / "other")
    environ = {"HOME": str(user), "ROS2COURSE_HOME": str(wanted.path)}
    assert find_home(None, environ, other.path) == wanted


def test_the_folder_or_one_above_goes_before_the_usual_one(tmp_path: Path, user: Path) -> None:
    wanted = create_home(tmp_path / "wanted")
    assert find_home(None, {"HOME": str(user)}, wanted.path) == wanted
    assert find_home(None, {"HOME": str(user), "ROS2COURSE_HOME": ""}, wanted.workspace / "src") == wanted


def test_the_usual_one_comes_last(tmp_path: Path, user: Path) -> None:
    assert find_home(None, {"HOME": str(user)}, tmp_path).path == user / "ros2course"


def test_without_any_the_way_to_one_is_told(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="no course home") as caught:
        find_home(None, {"HOME": str(tmp_path)}, tmp_path)
    assert "ros2course init" in (caught.value.next_step or "")


@pytest.mark.parametrize("by", ["--home", "ROS2COURSE_HOME"])
def test_one_that_is_named_is_not_replaced_by_another(tmp_path: Path, user: Path, by: str) -> None:
    option = tmp_path if by == "--home" else None
    environ = {"HOME": str(user), **({} if option else {"ROS2COURSE_HOME": str(tmp_path)})}
    with pytest.raises(UsageError, match=f"from {by}.* is not a course home") as caught:
        find_home(option, environ, user / "ros2course")
    assert caught.value.next_step == f"create one there: ros2course init {tmp_path}"


def test_environment_and_folder_are_the_process_s_own_unless_given(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    wanted = create_home(tmp_path / "wanted")
    monkeypatch.setenv("ROS2COURSE_HOME", str(wanted.path))
    assert find_home() == wanted
    monkeypatch.delenv("ROS2COURSE_HOME")
    monkeypatch.chdir(wanted.workspace)
    assert find_home() == wanted


def test_a_deleted_folder_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    with pytest.raises(UsageError, match="no longer exists"):
        find_home(None, {"HOME": str(tmp_path)})


def test_none_by_default(tmp_path: Path) -> None:
    assert remembered_course(create_home(tmp_path / "home")) is None


def test_the_last_one_that_was_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home = create_home(tmp_path / "home")
    monkeypatch.chdir(tmp_path)
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        remember_course(home, Path(name))
        assert remembered_course(home) == tmp_path / name


def test_one_that_is_gone(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    remember_course(home, tmp_path / "gone")
    with pytest.raises(UsageError, match="gone") as caught:
        remembered_course(home)
    assert caught.value.next_step == f"say where it is now: ros2course init {home.path} --course DIR"
