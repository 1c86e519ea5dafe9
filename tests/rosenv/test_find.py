from dataclasses import replace
from pathlib import Path

import pytest

from course.errors import MissingHere
from course.rosenv import find_ros
from course.rosenv.setup_files import is_stamped, place_of, write_stamp
from tests.rosenv.made_up import installed, no_wheels, pip_ros, python, wheels, workspace, write


def sourced(prefix: Path, distro: str = "jazzy") -> dict[str, str]:
    return {"ROS_DISTRO": distro, "AMENT_PREFIX_PATH": str(prefix), "PATH": "/usr/bin"}


def test_a_sourced_ros_comes_first(tmp_path: Path) -> None:
    host = replace(wheels(tmp_path / "venv"), installed=tmp_path / "opt")
    installed(tmp_path / "opt")
    installed(tmp_path / "own")
    ros = find_ros(sourced(tmp_path / "own"), host)
    assert (ros.origin, ros.prefix, ros.distro, ros.notes) == ("sourced", tmp_path / "own", "jazzy", ())
    assert ros.python == tmp_path / "own/bin/python3.11"
    assert ros.python_packages == tmp_path / "own/lib/python3.11/site-packages"


def test_an_installed_ros_comes_before_pip(tmp_path: Path) -> None:
    host = replace(wheels(tmp_path / "venv"), installed=tmp_path / "opt")
    installed(tmp_path / "opt")
    ros = find_ros({}, host)
    assert (ros.origin, ros.prefix, ros.distro) == ("installed", tmp_path / "opt", "jazzy")


def test_the_wheels_are_found_where_nothing_else_is(tmp_path: Path) -> None:
    ros = find_ros({}, wheels(tmp_path / "venv"))
    assert (ros.origin, ros.prefix, ros.distro) == ("pip", tmp_path / "venv", "jazzy")
    assert ros.python == tmp_path / "venv/bin/python3"


@pytest.mark.parametrize(("changed", "identity_changes"), [("plain", False), ("compiled", True)])
def test_our_own_packages_belong_to_what_was_found(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, changed: str, identity_changes: bool
) -> None:
    """What is compiled on top of the wheels takes part in builds; all of them are laid out."""
    host, root = wheels(tmp_path / "venv"), tmp_path / "underlay"
    for name in ("plain", "compiled"):
        for file in ("package.xml", "setup.py", "setup.cfg"):
            write(root / "src" / name / file, "")
    write(root / "src/compiled/CMakeLists.txt", "")
    monkeypatch.setattr("course.rosenv.find.source_root", lambda: root)
    before = find_ros({}, host)
    write(root / "src" / changed / "package.xml", "<package/>")
    after = find_ros({}, host)
    assert before.underlay != after.underlay
    assert (before.identity != after.identity) is identity_changes
    place = place_of(before, {})
    write_stamp(before, place)
    assert is_stamped(before, place) and not is_stamped(after, place)


def test_the_python_of_the_wheels_has_one_name_however_it_was_started(tmp_path: Path) -> None:
    host = replace(wheels(tmp_path / "venv"), executable=tmp_path / "venv/bin/python")
    assert pip_ros(host).python == tmp_path / "venv/bin/python3"
    host.prefix.joinpath("bin/python3").unlink()
    assert pip_ros(host).python == host.executable


def test_our_own_setup_bash_means_the_wheels_even_where_ros_is_installed(tmp_path: Path) -> None:
    host = replace(wheels(tmp_path / "venv"), installed=tmp_path / "opt")
    installed(tmp_path / "opt")
    assert find_ros(sourced(host.prefix), host).origin == "pip"


def test_the_wheels_of_another_copy_of_the_course_give_way_to_ours(tmp_path: Path) -> None:
    other, host = wheels(tmp_path / "other"), wheels(tmp_path / "venv")
    ros = find_ros(sourced(other.prefix), host)
    assert (ros.origin, ros.prefix) == ("pip", host.prefix)


@pytest.mark.parametrize("distro", ["humble", "kilted", "rolling"])
def test_another_distribution_is_used_with_a_note(tmp_path: Path, distro: str) -> None:
    installed(tmp_path / "own")
    ros = find_ros(sourced(tmp_path / "own", distro), no_wheels(tmp_path))
    assert ros.distro == distro
    assert distro in ros.notes[0]


def test_a_half_sourced_environment_is_not_a_ros(tmp_path: Path) -> None:
    host = wheels(tmp_path / "venv")
    (mine,) = workspace(tmp_path / "install", "mine")
    assert find_ros(sourced(mine), host).origin == "pip"
    installed(tmp_path / "own")
    assert find_ros({"AMENT_PREFIX_PATH": str(tmp_path / "own")}, host).origin == "pip"


def test_a_workspace_on_top_does_not_change_the_identity(tmp_path: Path) -> None:
    installed(tmp_path / "own")
    host = no_wheels(tmp_path)
    (mine,) = workspace(tmp_path / "install", "mine")
    alone = find_ros(sourced(tmp_path / "own"), host)
    with_it = {**sourced(tmp_path / "own"), "AMENT_PREFIX_PATH": f"{mine}:{tmp_path / 'own'}"}
    assert find_ros(with_it, host) == alone


def test_sourced_and_merely_installed_is_the_same_identity(tmp_path: Path) -> None:
    host = no_wheels(tmp_path)
    installed(host.installed)
    assert find_ros({}, host).identity == find_ros(sourced(host.installed), host).identity


def test_a_sourced_ros_for_another_python_is_refused_with_the_way_out(tmp_path: Path) -> None:
    installed(tmp_path / "own", "3.12")
    with pytest.raises(MissingHere) as caught:
        find_ros(sourced(tmp_path / "own"), wheels(tmp_path / "venv"))
    assert "is for python3.12; the course runs on Python 3.11" in caught.value.what
    assert "remove .venv" in (caught.value.next_step or "")


def test_an_installed_ros_for_another_python_yields_to_wheels_that_work(tmp_path: Path) -> None:
    host = replace(wheels(tmp_path / "venv"), installed=tmp_path / "opt")
    installed(tmp_path / "opt", "3.12")
    ros = find_ros({}, host)
    assert ros.origin == "pip"
    assert "python3.12" in ros.notes[0]


def test_an_installed_ros_for_another_python_is_refused_where_there_are_no_wheels(tmp_path: Path) -> None:
    host = no_wheels(tmp_path)
    installed(host.installed, "3.12")
    with pytest.raises(MissingHere, match=r"is for python3\.12"):
        find_ros({}, host)


def test_the_python_of_a_ros_may_stand_on_the_path(tmp_path: Path) -> None:
    installed(tmp_path / "own", "3.99")
    (tmp_path / "own/bin/python3.99").unlink()
    host = replace(no_wheels(tmp_path), python=(3, 99))
    with pytest.raises(MissingHere) as caught:
        find_ros(sourced(tmp_path / "own"), host)
    assert caught.value.next_step == "Run: sudo apt install python3.99"
    python(tmp_path / "usr", "python3.99")
    environ = {**sourced(tmp_path / "own"), "PATH": f"/usr/bin:{tmp_path / 'usr/bin'}"}
    assert find_ros(environ, host).python == tmp_path / "usr/bin/python3.99"


def test_no_ros_at_all_says_how_to_get_it(tmp_path: Path) -> None:
    with pytest.raises(MissingHere) as caught:
        find_ros({}, no_wheels(tmp_path))
    assert "./ros2course next" in (caught.value.next_step or "")
    assert "pip install '.[jazzy]'" in (caught.value.next_step or "")


def test_no_ros_on_a_machine_without_wheels_says_so(tmp_path: Path) -> None:
    with pytest.raises(MissingHere, match="aarch64"):
        find_ros({}, replace(no_wheels(tmp_path), machine="aarch64"))


def test_wheels_without_a_middleware_name_the_one_that_is_missing(tmp_path: Path) -> None:
    host = wheels(tmp_path / "venv")
    next(host.site_packages.glob("ros_rmw_*.dist-info")).rmdir()
    with pytest.raises(MissingHere) as caught:
        pip_ros(host)
    assert f"{host.executable} -m pip install 'ros-rclpy[fastrtps]==7.1.6'" in (caught.value.next_step or "")
