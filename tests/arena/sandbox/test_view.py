"""What is shown of the machine, and what of that is hidden."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

import course
from course.arena.sandbox.inner import arguments
from course.arena.sandbox.plan import Plan
from course.arena.sandbox.view import hidden, shown
from course.rosenv import Ros

ENGINE = Path(course.__file__).parent
ROS = Ros("pip", "jazzy", Path(sys.prefix), Path(sys.executable), "test")


def visible(path: Path, places: tuple[str, ...]) -> bool:
    return any(path.is_relative_to(place) for place in places)


def test_ros_and_its_python_are_shown() -> None:
    found = shown(ROS, {})
    assert visible(Path(sys.executable), found)
    assert visible(Path(sys.base_prefix) / "lib", (*found, "/usr"))


def test_what_the_environment_leads_to_is_shown_but_for_the_path(tmp_path: Path) -> None:
    """On PATH are folders of the learner's own."""
    for name in ("overlay", "bin"):
        (tmp_path / name).mkdir()
    lists = {"AMENT_PREFIX_PATH": f"{tmp_path}/overlay:{tmp_path}/gone", "PATH": f"{tmp_path}/bin"}
    found = shown(ROS, lists)
    assert str(tmp_path / "overlay") in found
    assert not {str(tmp_path / "gone"), str(tmp_path / "bin")} & set(found)


def test_links_are_shown_with_what_they_lead_to(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "real")
    assert {str(tmp_path / "real"), str(tmp_path / "link")} <= set(shown(ROS, {}, [tmp_path / "link"]))


def test_never_the_root(tmp_path: Path) -> None:
    assert "/" not in shown(ROS, {}, [Path("/"), tmp_path])


def test_the_engine_is_hidden_where_it_lies_in_what_is_shown() -> None:
    assert str(ENGINE) in hidden((str(ENGINE.parent),))
    assert hidden(("/usr",)) == () or ENGINE.is_relative_to("/usr")


def test_graders_and_solutions_are_not_shown() -> None:
    """Only two programs of ours are, which run among the learner's."""
    found = shown(ROS, {})
    root = ENGINE.parent
    assert not visible(root / "graders", found)
    assert not visible(root / "solutions", found)
    assert sorted(Path(path).name for path in found if Path(path).is_relative_to(ENGINE)) == [
        "probe_program.py",
        "type_probe.py",
    ]


@pytest.mark.parametrize("user", [None, 2_000_000_000])
def test_what_is_hidden_comes_after_what_is_around_it_and_before_what_is_in_it(user: int | None) -> None:
    plan = Plan(user, ("/opt/all", "/opt/all/course/tool.py"), ("/opt/all/course",))
    words = arguments(plan, (Path("/scratch"),))
    places = [words.index(path) for path in ("/opt/all", "/opt/all/course", "/opt/all/course/tool.py")]
    assert places == sorted(places)
    assert ("--unshare-user" in words) == (user is None)
    assert "--unshare-pid" in words


def test_nothing_but_the_writable_stays_writable() -> None:
    words = arguments(Plan(None, (), ("/opt/course",)), (Path("/scratch"),))
    after = [words[index + 1] for index, word in enumerate(words) if word == "--remount-ro"]
    assert after == ["/", "/dev", "/opt/course"]
    assert [words[index + 1] for index, word in enumerate(words) if word == "--bind"] == ["/scratch"]
