"""What is visible of the machine: a list without any course."""

from __future__ import annotations

import errno
import os
import sys
from pathlib import Path

import pytest

import course
from course.isolation import view as module
from course.isolation.bubblewrap import arguments
from course.isolation.isolation_plan import IsolationPlan
from course.isolation.view import View, linked, view
from course.model import replace
from course.rosenv import Ros

ENGINE = Path(course.__file__).parent
ROS = Ros("pip", "jazzy", Path(sys.prefix), Path(sys.executable), "test")
NEEDED = (
    "rclpy/__init__.py",
    "ros_rclpy.libs/libspdlog.so",
    "numpy/__init__.py",
    "numpy-2.4.6.dist-info/entry_points.txt",
    "em.py",
    "distutils-precedence.pth",
    "colcon_core/__init__.py",
    "colcon_core-0.21.3.dist-info/entry_points.txt",
)
OF_A_PREFIX = ("bin/python3", "lib/librcl.so", "include/rcl/rcl.h", "share/rclpy/package.xml", "pyvenv.cfg")
NOT_NEEDED = (
    "course/_course/solutions/18/node.py",
    "ros2course-0.1.0.dist-info/RECORD",
    "another_course/chapters/01/lesson.yaml",
    "ros_course/solutions/node.py",
    "_editable_impl_ros2course.pth",
    "dask/__init__.py",
    "numpy-stubs/__init__.pyi",
    "rcl/_dummy.so",
)


@pytest.fixture
def prefix(tmp_path: Path) -> Path:
    """An environment with ROS, and with all kinds of other packages."""
    for name in NEEDED + NOT_NEEDED:
        lay(tmp_path / "env/lib/python3.11/site-packages" / name)
    for name in ("rclpy", "rcl"):
        lay(tmp_path / "env/share/ament_index/resource_index/packages" / name)
    for name in OF_A_PREFIX:
        lay(tmp_path / "env" / name)
    (tmp_path / "env/lib64").symlink_to("lib")
    return tmp_path / "env"


def lay(file: Path) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.touch()


def wheels(prefix: Path) -> Ros:
    return Ros("pip", "jazzy", prefix, prefix / "bin/python3", "test")


def test_ros_and_its_python_are_shown() -> None:
    seen = view(ROS, {})
    assert seen.shows(Path(sys.executable))
    assert seen.shows(Path(sys.base_prefix) / "lib")


@pytest.mark.parametrize("name", NEEDED)
def test_packages_that_ros_needs_are_shown(prefix: Path, name: str) -> None:
    assert view(wheels(prefix), {}).shows(prefix / "lib/python3.11/site-packages" / name)


@pytest.mark.parametrize("name", NOT_NEEDED)
def test_no_other_package_is(prefix: Path, name: str) -> None:
    """Neither through the environment, nor under another name of the folder."""
    folders = {name: str(prefix) for name in ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH", "LD_LIBRARY_PATH")}
    named = {**folders, "PYTHONPATH": str(prefix / "lib/python3.11/site-packages")}
    seen = view(wheels(prefix), named)
    assert not seen.shows(prefix / "lib/python3.11/site-packages" / name)
    words = arguments(IsolationPlan(None, seen.shown, seen.empty))
    assert words[words.index(str(prefix / "lib64")) - 2 :][:3] == ("--symlink", "lib", str(prefix / "lib64"))


def test_of_a_prefix_only_what_it_is_made_of_is_shown(prefix: Path) -> None:
    for name in ("home/solutions/node.py", "share/another_course/solutions/node.py", "notes.txt"):
        lay(prefix / name)
    seen = view(wheels(prefix), {})
    assert all(seen.shows(prefix / name) for name in OF_A_PREFIX)
    hidden = ("home/solutions/node.py", "share/another_course/solutions/node.py", "notes.txt")
    assert not any(seen.shows(prefix / name) for name in hidden)


def test_links_to_an_environment_show_no_more_of_it(prefix: Path, tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(prefix)
    seen = view(wheels(tmp_path / "link"), {})
    for place in (tmp_path / "link", prefix):
        packages = place / "lib/python3.11/site-packages"
        assert seen.shows(place / "lib/librcl.so")
        assert not any(seen.shows(packages / name) for name in NOT_NEEDED)
    assert seen.shows(tmp_path / "link/lib/python3.11/site-packages" / NEEDED[0])


def test_the_packages_of_another_python_are_not_shown(prefix: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The Python that made the environment: only its standard library is used."""
    monkeypatch.setattr(sys, "base_prefix", str(prefix))
    seen = view(ROS, {})
    assert seen.shows(prefix / "lib/librcl.so")
    assert not seen.shows(prefix / "lib/python3.11/site-packages" / NEEDED[0])
    monkeypatch.setattr(sys, "path", [*sys.path, str(prefix / "lib/python3.11/site-packages")])
    assert view(ROS, {}).shows(prefix / "lib/python3.11/site-packages" / NEEDED[0])


def test_what_the_environment_leads_to_is_shown_but_for_the_path(tmp_path: Path) -> None:
    """PATH contains the learner's own folders, and PYTHONPATH whatever an instructor likes."""
    for name in ("overlay", "bin", "mine"):
        (tmp_path / name).mkdir()
    lists = {"AMENT_PREFIX_PATH": f"{tmp_path}/overlay:{tmp_path}/gone:", "PATH": f"{tmp_path}/bin"}
    found = view(ROS, {**lists, "PYTHONPATH": f"{tmp_path}/mine"}).shown
    assert str(tmp_path / "overlay") in found
    assert not {str(tmp_path / name) for name in ("gone", "bin", "mine")} & set(found)


def test_links_are_shown_with_what_they_lead_to(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "real")
    found = view(ROS, {}, [tmp_path / "link"]).shown
    assert {str(tmp_path / "real"), str(tmp_path / "link")} <= set(found)


def test_never_the_root_nor_all_of_the_system(tmp_path: Path) -> None:
    found = view(ROS, {"AMENT_PREFIX_PATH": "/usr"}, [Path("/"), tmp_path]).shown
    assert not {"/", "/usr", "/usr/local"} & set(found)
    assert not any(view(ROS, {}).shows(Path("/usr", name)) for name in ("src/x", "local/src/x"))


def test_a_course_among_the_packages_of_the_system_is_not_shown(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("one/chapters", "two/_course/chapters", "three/pictures"):
        (tmp_path / name).mkdir(parents=True)
    monkeypatch.setattr(module, "_OF_THE_SYSTEM", (tmp_path,))
    seen = view(ROS, {}, [tmp_path])
    readable = [seen.shows(tmp_path / name / "x") for name in ("one", "two", "three")]
    assert readable == [False, False, True]


def test_of_the_engine_only_one_program_is_shown() -> None:
    """It runs alongside the learner's."""
    found = view(ROS, {}).shown
    root = ENGINE.parent
    assert not any(view(ROS, {}).shows(root / name) for name in ("graders", "solutions", "chapters"))
    assert sorted(Path(path).name for path in found if Path(path).is_relative_to(ENGINE)) == [
        "probe_program.py",
    ]


@pytest.mark.parametrize("user", [None, 2_000_000_000])
def test_what_is_hidden_comes_after_what_is_around_it_and_before_what_is_in_it(user: int | None) -> None:
    plan = IsolationPlan(user, ("/opt/all", "/opt/all/course/tool.py"), ("/opt/all/course",))
    words = arguments(replace(plan, write=("/scratch",)))
    places = [words.index(path) for path in ("/opt/all", "/opt/all/course", "/opt/all/course/tool.py")]
    assert places == sorted(places)
    assert ("--unshare-user" in words) == (user is None)
    assert "--unshare-pid" in words


def test_nothing_but_the_writable_stays_writable() -> None:
    words = arguments(IsolationPlan(None, (), ("/opt/course",), write=("/scratch",)))
    after = [words[index + 1] for index, word in enumerate(words) if word == "--remount-ro"]
    assert after == ["/", "/dev", "/proc", "/opt/course"]
    assert [words[index + 1] for index, word in enumerate(words) if word == "--bind"] == ["/scratch"]


def files(folder: Path) -> set[str]:
    return {str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file()}


@pytest.fixture
def packages(prefix: Path) -> View:
    """What is seen of the environment, with a package that is a link."""
    folder = prefix / "lib/python3.11/site-packages"
    (folder / "yaml").symlink_to("numpy")
    seen = view(wheels(prefix), {})
    return View(tuple(path for path in seen.shown if Path(path).is_relative_to(prefix)), (str(folder),))


def test_links_take_the_place_of_many_packages(packages: View, prefix: Path, tmp_path: Path) -> None:
    folder = prefix / "lib/python3.11/site-packages"
    old = os.umask(0o077)
    try:
        seen = linked(packages, tmp_path / "cache")
    finally:
        os.umask(old)
    links = dict(seen.linked)[str(folder)]
    assert files(Path(links)) == {*NEEDED}
    assert Path(links, "rclpy/__init__.py").samefile(folder / "rclpy/__init__.py")
    assert Path(links, "yaml").is_symlink() and Path(links, "yaml/__init__.py").exists()
    assert all(place.stat().st_mode & 0o055 == 0o055 for place in Path(links).rglob("*") if place.is_dir())
    assert Path(links).stat().st_mode & 0o055 == 0o055
    assert not any(Path(path).is_relative_to(folder) for path in (*seen.shown, *seen.empty))
    assert {*packages.shown, *packages.empty} >= {*seen.shown, *seen.empty}
    words = arguments(IsolationPlan(None, seen.shown, seen.empty, linked=seen.linked))
    at = words.index(links)
    assert words[at - 1 : at + 2] == ("--ro-bind", links, str(folder))
    assert linked(packages, tmp_path / "cache") == seen


def test_what_pip_replaces_is_linked_again(packages: View, prefix: Path, tmp_path: Path) -> None:
    ((folder, first),) = linked(packages, tmp_path / "cache").linked
    package = prefix / "lib/python3.11/site-packages/rclpy"
    package.rename(package.with_name("before"))
    lay(package / "__init__.py")
    lay(package / "node.py")
    ((_, second),) = linked(packages, tmp_path / "cache").linked
    assert Path(second, "rclpy/node.py").exists() > Path(first, "rclpy/node.py").exists()
    os.utime(first, (0, 0))
    os.utime(package, (1, 1))
    assert linked(packages, tmp_path / "cache").linked[0] not in ((folder, first), (folder, second))
    assert Path(second).exists() > Path(first).exists()


def test_without_links_all_is_as_it_was(
    packages: View, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise OSError(errno.EXDEV, "Invalid cross-device link")

    monkeypatch.setattr(os, "link", refuse)
    assert linked(packages, tmp_path / "cache") == packages
    assert list((tmp_path / "cache").iterdir()) == []
