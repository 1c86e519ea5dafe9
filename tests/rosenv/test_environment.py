""""""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from course.errors import MissingHere
from course.rosenv import Ros, find_ros, node_environment, plain_environment
from course.rosenv.environment import captured_variables
from tests.rosenv.made_up import installed, no_wheels, pip_ros, underlay, wheels, workspace


def outer(tmp_path: Path, **more: str) -> dict[str, str]:
    return {"PATH": "/usr/bin:/bin", "HOME": "/home/me", "ROS2COURSE_CACHE": str(tmp_path / "cache"), **more}


def test_the_wheels_get_everything_they_need(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    prefix, packages, ours = ros.prefix, ros.python_packages, underlay(ros)
    environment = node_environment(ros, environ=outer(tmp_path))
    assert environment["AMENT_PREFIX_PATH"] == environment["CMAKE_PREFIX_PATH"] == f"{ours}:{prefix}"
    assert environment["PATH"] == f"{ours}/bin:{prefix}/bin:/usr/bin:/bin"
    assert environment["PYTHONPATH"].split(":")[0] == f"{ours}/lib/python3.11/site-packages"
    libraries = [f"{ours}/lib", f"{prefix}/lib", f"{packages}/ros_fastrtps.libs", f"{packages}/ros_rcl.libs"]
    assert environment["LD_LIBRARY_PATH"].split(":") == libraries
    assert environment["_ROS_WHEELS_BOOTSTRAP_COMPLETE"] == "1"
    assert environment["VIRTUAL_ENV"] == str(prefix)
    assert [environment[f"ROS_{name}"] for name in ("DISTRO", "VERSION", "PYTHON_VERSION")] == [
        "jazzy",
        "2",
        "3",
    ]
    assert environment["FASTDDS_BUILTIN_TRANSPORTS"] == "UDPv4"
    assert Path(environment["FASTRTPS_DEFAULT_PROFILES_FILE"]).is_file()


def test_only_the_basics_of_the_caller_get_in(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    unwanted = {
        "PYTHONPATH": "/mine",
        "LD_LIBRARY_PATH": "/mine",
        "LD_PRELOAD": "/mine",
        "ROS_DOMAIN_ID": "7",
        "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp",
        "VIRTUAL_ENV": "/mine",
        "SECRET": "/mine",
    }
    environment = node_environment(ros, environ=outer(tmp_path, LANG="de", LC_TIME="fr", TZ="x", **unwanted))
    assert "/mine" not in ":".join(environment.values())
    assert {"ROS_DOMAIN_ID", "RMW_IMPLEMENTATION", "LD_PRELOAD", "SECRET"}.isdisjoint(environment)
    assert [environment[name] for name in ("HOME", "LANG", "LC_TIME", "TZ")] == ["/home/me", "de", "fr", "x"]


def test_an_empty_environment_still_has_a_path(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    environment = node_environment(ros, environ={"ROS2COURSE_CACHE": str(tmp_path)})
    assert environment["PATH"].endswith(":/usr/local/bin:/usr/bin:/bin")


def test_overlays_lie_on_top_and_the_last_one_wins(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    one, two = workspace(tmp_path / "store", "one", "two")
    environment = node_environment(ros, [one, two], outer(tmp_path))
    assert environment["AMENT_PREFIX_PATH"] == f"{two}:{one}:{underlay(ros)}:{ros.prefix}"
    assert environment["CMAKE_PREFIX_PATH"] == f"{two}:{one}:{underlay(ros)}:{ros.prefix}"
    assert environment["PATH"].startswith(f"{two}/bin:{one}/bin:{underlay(ros)}/bin:{ros.prefix}/bin:")
    libraries = f"{two}/lib:{one}/lib:{underlay(ros)}/lib:{ros.prefix}/lib:"
    assert environment["LD_LIBRARY_PATH"].startswith(libraries)
    site = "lib/python3.11/site-packages"
    assert environment["PYTHONPATH"].startswith(f"{two}/{site}:{one}/{site}")
    assert environment["PKG_CONFIG_PATH"] == f"{two}/lib/pkgconfig:{one}/lib/pkgconfig"


def test_debians_folders_for_python_packages_are_known(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    (tmp_path / "one/local/lib/python3.11/dist-packages").mkdir(parents=True)
    environment = node_environment(ros, [tmp_path / "one"], outer(tmp_path))
    assert environment["PYTHONPATH"].startswith(f"{tmp_path}/one/local/lib/python3.11/dist-packages")
    assert f"{tmp_path}/one/lib" not in environment["LD_LIBRARY_PATH"], "there is no such folder"


def test_another_ros_that_is_sourced_is_not_mixed_into_the_wheels(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    installed(tmp_path / "humble")
    (mine,) = workspace(tmp_path / "install", "mine")
    environ = outer(
        tmp_path,
        AMENT_PREFIX_PATH=f"{mine}:{tmp_path}/humble",
        COLCON_PREFIX_PATH=f"{tmp_path}/install",
        PATH=f"{mine}/bin:{tmp_path}/humble/bin:/usr/bin",
        ROS_DISTRO="humble",
        PYTHONPATH=f"{tmp_path}/humble/lib/python3.10/site-packages",
    )
    environment = node_environment(ros, environ=environ)
    assert environment["PATH"] == f"{underlay(ros)}/bin:{ros.prefix}/bin:/usr/bin"
    assert f"{tmp_path}/humble" not in ":".join(environment.values())
    assert str(mine) not in ":".join(environment.values())


def test_a_sourced_ros_is_taken_as_it_is_but_for_the_workspace_on_top(tmp_path: Path) -> None:
    own = tmp_path / "own"
    installed(own)
    mine, build = workspace(tmp_path / "install", "mine")[0], workspace(tmp_path / "store", "build")[0]
    environ = outer(
        tmp_path,
        ROS_DISTRO="jazzy",
        AMENT_PREFIX_PATH=f"{mine}:{own}:/extra",
        CMAKE_PREFIX_PATH=f"{mine}",
        LD_LIBRARY_PATH=f"{mine}/lib:{own}/lib:/extra/lib",
        PYTHONPATH=f"{mine}/lib/python3.11/site-packages:{own}/lib/python3.11/site-packages",
        PATH=f"{mine}/bin:{own}/bin:/usr/bin",
    )
    ros = find_ros(environ, wheels(tmp_path / "venv"))
    environment = node_environment(ros, [build], environ)
    assert environment["AMENT_PREFIX_PATH"] == f"{build}:{own}:/extra"
    assert environment["CMAKE_PREFIX_PATH"] == str(build)
    assert environment["LD_LIBRARY_PATH"] == f"{build}/lib:{own}/lib:/extra/lib"
    assert environment["PATH"] == f"{build}/bin:{own}/bin:/usr/bin"
    assert str(mine) not in ":".join(environment.values())
    assert f"{tmp_path}/venv" not in ":".join(environment.values()), "the wheels were mixed in"


def test_an_installed_ros_is_sourced_and_the_wheels_stay_out(tmp_path: Path) -> None:
    host = replace(wheels(tmp_path / "venv"), installed=tmp_path / "opt")
    installed(tmp_path / "opt")
    (mine,) = workspace(tmp_path / "install", "mine")
    ros = find_ros({}, host)
    environ = outer(tmp_path, AMENT_PREFIX_PATH=str(mine), PATH=f"{mine}/bin:/usr/bin")
    environment = node_environment(ros, environ=environ)
    assert environment["AMENT_PREFIX_PATH"] == str(tmp_path / "opt")
    assert environment["PATH"] == f"{tmp_path}/opt/bin:/usr/bin"
    assert "GZ_PATH" not in environment
    assert f"{tmp_path}/venv" not in ":".join(environment.values()), "the wheels were mixed in"
    assert "underlay" not in ":".join(environment.values()), "our own packages were mixed in"
    assert environment["FASTDDS_BUILTIN_TRANSPORTS"] == "UDPv4"


def test_a_sourced_ros_is_found_again_from_an_environment_without_it(tmp_path: Path) -> None:
    installed(tmp_path / "own")
    environ = outer(tmp_path, ROS_DISTRO="jazzy", AMENT_PREFIX_PATH=str(tmp_path / "own"))
    ros = find_ros(environ, no_wheels(tmp_path))
    assert node_environment(ros, environ=outer(tmp_path))["AMENT_PREFIX_PATH"] == str(tmp_path / "own")


def test_a_sourced_ros_is_not_mixed_with_one_that_is_sourced_elsewhere(tmp_path: Path) -> None:
    for name in ("own", "other"):
        installed(tmp_path / name)
    environ = outer(tmp_path, ROS_DISTRO="jazzy", AMENT_PREFIX_PATH=str(tmp_path / "own"))
    ros = find_ros(environ, no_wheels(tmp_path))
    environ["AMENT_PREFIX_PATH"] = str(tmp_path / "other")
    assert node_environment(ros, environ=environ)["AMENT_PREFIX_PATH"] == str(tmp_path / "own")


@pytest.mark.parametrize("kind", ["pip", "installed"])
def test_a_process_in_that_environment_finds_the_same_ros(tmp_path: Path, kind: str) -> None:
    host = wheels(tmp_path / "venv")
    if kind == "installed":
        host = replace(host, installed=tmp_path / "opt")
        installed(tmp_path / "opt")
    ros = find_ros({}, host)
    first, second = workspace(tmp_path / "store", "first", "second")
    inside = {**node_environment(ros, [first], outer(tmp_path)), "ROS2COURSE_CACHE": str(tmp_path / "cache")}
    again = find_ros(inside, host)
    assert (again.prefix, again.identity) == (ros.prefix, ros.identity)
    deeper = node_environment(again, [second], inside)
    assert deeper == node_environment(ros, [second], outer(tmp_path))


def test_of_a_sourced_shell_nothing_of_ros_is_left(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    outer = {"PATH": "/usr/bin:/bin", "HOME": "/home/me", "ROS2COURSE_CACHE": str(tmp_path / "cache")}
    sourced = node_environment(ros, environ=outer)
    assert str(ros.prefix) in sourced["PATH"]
    plain = plain_environment(ros, {**sourced, "ROS_DOMAIN_ID": "7", "SECRET": "x", "LANG": "de"})
    assert plain == {"PATH": "/usr/bin:/bin", "HOME": "/home/me", "LANG": "de"}


def test_an_active_environment_of_the_wheels_is_left_out_too(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    plain = plain_environment(ros, {"PATH": f"{ros.prefix}/bin:/usr/bin"})
    assert plain == {"PATH": "/usr/bin"}


def test_without_a_path_there_is_the_usual_one(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    assert plain_environment(ros, {})["PATH"] == "/usr/local/bin:/usr/bin:/bin"


@pytest.fixture
def ros(tmp_path: Path) -> Ros:
    host = no_wheels(tmp_path)
    installed(host.installed)
    return find_ros({}, host)


@pytest.fixture
def environ(tmp_path: Path) -> dict[str, str]:
    return {
        "ROS2COURSE_CACHE": str(tmp_path / "cache"),
        "FORBIDDEN": "1",
        "PATH": "/mine",
        "HOME": "/home/me",
    }


def test_setup_bash_is_sourced_in_a_plain_shell(ros: Ros, environ: dict[str, str]) -> None:
    variables = captured_variables(ros, environ)
    assert variables["AMENT_PREFIX_PATH"] == str(ros.prefix)
    assert variables["PATH"] == f"{ros.prefix}/bin", "the PATH of the shell got in"
    assert set(variables) == {"AMENT_PREFIX_PATH", "LD_LIBRARY_PATH", "PATH", "PYTHONPATH"}


def test_it_is_sourced_once_and_again_when_the_ros_changes(ros: Ros, environ: dict[str, str]) -> None:
    first = captured_variables(ros, environ)
    assert captured_variables(ros, environ) == first
    assert (ros.prefix / "sourced").read_text() == "once\n"
    captured_variables(replace(ros, identity="another"), environ)
    assert (ros.prefix / "sourced").read_text() == "once\nonce\n"


@pytest.mark.parametrize("text", ["", "{", "[]", '{"identity": 1}', '{"identity": "ID", "variables": []}'])
def test_a_damaged_memory_is_made_anew(ros: Ros, environ: dict[str, str], tmp_path: Path, text: str) -> None:
    first = captured_variables(ros, environ)
    (memory,) = (tmp_path / "cache").rglob("*.json")
    memory.write_text(text.replace("ID", ros.identity))
    assert captured_variables(ros, environ) == first


def test_a_cache_that_cannot_be_written_costs_only_time(ros: Ros, tmp_path: Path) -> None:
    (tmp_path / "cache").write_text("a file, not a folder")
    assert (
        captured_variables(ros, {"ROS2COURSE_CACHE": str(tmp_path / "cache")})["PATH"] == f"{ros.prefix}/bin"
    )


@pytest.mark.parametrize(
    ("script", "reason"), [("echo broken >&2; exit 1", "broken"), ("true", "sets no AMENT_PREFIX_PATH")]
)
def test_a_broken_setup_bash_is_named(ros: Ros, environ: dict[str, str], script: str, reason: str) -> None:
    (ros.prefix / "setup.bash").write_text(script)
    with pytest.raises(MissingHere, match=reason) as caught:
        captured_variables(ros, environ)
    assert f"bash -c 'source {ros.prefix}/setup.bash'" in (caught.value.next_step or "")
