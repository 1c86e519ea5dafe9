"""Chapters 6 to 11: make packages, build them, source them, run them."""

from __future__ import annotations

from pathlib import Path

from tests.underlay.tutorial.learner import LAMPS, WORKSPACE, create
from tests.underlay.tutorial.room import Room
from tests.underlay.tutorial.terminal import Terminal, in_order

PACKAGE = "python_package_with_a_node"
OPTIONS = (
    "--package-format {2,3}",
    "--description DESCRIPTION",
    "--license LICENSE",
    "--destination-directory DESTINATION_DIRECTORY",
    "--build-type {cmake,ament_cmake,ament_python}",
    "--dependencies DEPENDENCIES [DEPENDENCIES ...]",
    "--maintainer-email MAINTAINER_EMAIL",
    "--maintainer-name MAINTAINER_NAME",
    "--node-name NODE_NAME",
    "--library-name LIBRARY_NAME",
)


def test_pkg_create_tells_its_options(at_home: Room) -> None:
    terminal = at_home.terminal(columns=80)
    told = terminal.run("ros2 pkg create --help")
    assert in_order(told.text, "usage: ros2 pkg create", "package_name", "options:", *OPTIONS)
    assert all(len(line) <= 80 for line in told.lines)
    assert terminal.run("ros2 pkg create -h") == told


MISTYPED = {
    "": "the following arguments are required: package_name",
    "lamp --build-type ament_pyton": "invalid choice: 'ament_pyton'",
    "lamp --build-type": "expected one argument",
    "lamp --dependencies": "expected at least one argument",
    "lamp --de x": "ambiguous option: --de could match --description, --destination-directory",
    "lamp --nodename x": "unrecognized arguments: --nodename",
}


def test_pkg_create_mistyped(at_home: Room) -> None:
    terminal = at_home.terminal()
    terminal.run(f"cd ~/{WORKSPACE}/src")
    for words, answer in MISTYPED.items():
        assert answer in terminal.run(f"ros2 pkg create {words}", code=2)
    assert not terminal.run("ls").text


def test_pkg_create_with_everything(at_home: Room) -> None:
    terminal = at_home.terminal()
    terminal.run("git config --global user.email ada@example.org")
    terminal.run(f"cd ~/{WORKSPACE}")
    created = terminal.run(
        "ros2 pkg create lamps --build-type ament_python --destination-directory src "
        "--description 'All lamps at once' --license MIT --maintainer-name Ada --node-name lamp "
        "--library-name shades --dependencies rclpy std_msgs --package-format 3"
    )
    assert in_order(
        created.text,
        "going to create a new package\npackage name: lamps\n",
        "description: All lamps at once\nmaintainer: ['Ada <ada@example.org>']\nlicenses: ['MIT']\n",
        "build type: ament_python\ndependencies: ['rclpy', 'std_msgs']\nnode_name: lamp\n",
        "library_name: shades\n",
        "creating folder src/lamps\n",
    )
    assert "WARNING" not in created
    manifest = terminal.run("cat src/lamps/package.xml")
    assert in_order(
        manifest.text,
        '<package format="3">',
        "<name>lamps</name>",
        "<description>All lamps at once</description>",
        '<maintainer email="ada@example.org">Ada</maintainer>',
        "<license>MIT</license>",
        "<depend>rclpy</depend>",
        "<depend>std_msgs</depend>",
        "<build_type>ament_python</build_type>",
    )
    assert terminal.run("ls src/lamps").text.split() == (
        "LICENSE lamps package.xml resource setup.cfg setup.py test".split()
    )
    assert "already exists" in terminal.run("ros2 pkg create lamps --destination-directory src", code=1)
    terminal.run("colcon build && source install/setup.bash")
    assert terminal.run("ros2 run lamps lamp").text == "Hi from lamps.\n"
    assert terminal.run("ros2 pkg xml lamps --tag description").text == "All lamps at once\n"


def test_the_simplest_package(at_home: Room) -> None:
    name = "the_simplest_python_package"
    terminal = at_home.terminal()
    terminal.run(f"cd ~/{WORKSPACE}/src")
    created = terminal.run(f"ros2 pkg create {name} --build-type ament_python")
    assert in_order(
        created.text, f"creating ./{name}/package.xml", f"creating ./{name}/setup.py", "[WARNING]"
    )
    files = terminal.run(f"find {name} -type f | sort").lines
    assert files == [
        f"{name}/{file}"
        for file in (
            "package.xml",
            f"resource/{name}",
            "setup.cfg",
            "setup.py",
            "test/test_copyright.py",
            "test/test_flake8.py",
            "test/test_pep257.py",
            f"{name}/__init__.py",
        )
    ]
    terminal.run("cd ..")
    built = terminal.run("colcon build")
    assert in_order(built.text, f"Starting >>> {name}", f"Finished <<< {name}", "Summary: 1 package finished")
    assert terminal.run("ls").text.split() == ["build", "install", "log", "src"]
    terminal.run(f"ros2 pkg list | grep {name}", code=1)
    terminal.run("source install/setup.bash")
    assert terminal.run(f"ros2 pkg list | grep {name}").text == f"{name}\n"
    prefix = terminal.run(f"ros2 pkg prefix {name}").text.strip()
    assert prefix == f"{at_home.home}/{WORKSPACE}/install/{name}"
    assert not terminal.run(f"ros2 pkg executables {name}").text
    assert len(terminal.run("ros2 pkg list | head -n 3").lines) == 3


def test_a_node_from_a_template(at_home: Room) -> None:
    first = at_home.terminal()
    first.run(f"cd ~/{WORKSPACE}/src")
    first.run(f"ros2 pkg create {PACKAGE} --build-type ament_python --node-name sample_python_node")
    first.run("cd ..")
    first.run("colcon build --symlink-install")
    first.run("rm -r build install log")
    first.run(f"colcon build --packages-select {PACKAGE}")
    _it_is_not_known_before_sourcing(at_home.terminal())
    first.run("source install/setup.bash")
    _it_runs(first)
    first.run("echo 'source ~/ros2_tutorial_workspace/install/setup.bash' >> ~/.bashrc")
    _it_runs(at_home.terminal())


def _it_is_not_known_before_sourcing(terminal: Terminal) -> None:
    answer = terminal.run(f"ros2 run {PACKAGE} sample_python_node", code=1)
    assert answer.text == f"Package '{PACKAGE}' not found\n"
    terminal.run(f"cd ~/{WORKSPACE}")
    terminal.run("source install/setup.bash")
    _it_runs(terminal)


def _it_runs(terminal: Terminal) -> None:
    ran = terminal.run(f"ros2 run {PACKAGE} sample_python_node")
    assert ran.text == f"Hi from {PACKAGE}.\n"
    assert terminal.run(f"ros2 pkg executables {PACKAGE}").text == f"{PACKAGE} sample_python_node\n"
    answer = terminal.run(f"ros2 run {PACKAGE} sample_pyton_node", code=1)
    assert answer.text == "No executable found\n"
    usage = terminal.run(f"ros2 run {PACKAGE}", code=2)
    assert "the following arguments are required: executable_name" in usage
    timed = terminal.run(f"ros2 run --prefix 'env GREETING=hello' {PACKAGE} sample_python_node")
    assert timed == ran
    shown = terminal.run(f"ros2 run --prefix 'echo before' {PACKAGE} sample_python_node --after")
    assert in_order(shown.text, "before /", f"/lib/{PACKAGE}/sample_python_node --after\n")


def test_only_what_is_asked_for_is_built(at_home: Room) -> None:
    terminal = at_home.terminal()
    create(terminal, *(f"{name} --build-type ament_python" for name in ("first", "second")))
    built = terminal.run("colcon build --packages-select second")
    assert "Finished <<< second" in built and "first" not in built
    assert "Summary: 0 packages finished" in terminal.run("colcon build --packages-select third")
    assert "unrecognized arguments" in terminal.run("colcon build --package-select first", code=2)
    terminal.run("source install/setup.bash")
    terminal.run("ros2 pkg prefix first", code=1)


def test_a_change_in_the_sources_with_symlink_install(at_home: Room) -> None:
    terminal = at_home.terminal()
    create(terminal, LAMPS)
    terminal.run("colcon build --symlink-install")
    terminal.run("source install/setup.bash")
    assert terminal.run("ros2 run lamps lamp").text == "Hi from lamps.\n"
    terminal.run("sed -i 's/Hi from/Greetings from/' src/lamps/lamps/lamp.py")
    assert terminal.run("ros2 run lamps lamp").text == "Greetings from lamps.\n"


def test_a_broken_setup_file(at_home: Room) -> None:
    terminal = at_home.terminal()
    create(terminal, LAMPS)
    setup = Path(at_home.home, WORKSPACE, "src/lamps/setup.py")
    setup.write_text(setup.read_text().replace("'lamp = lamps.lamp:main'", "'lamp = lamps.lamp:main"))
    failed = terminal.run("colcon build", code=1)
    assert in_order(failed.text, "SyntaxError", "Failed   <<< lamps", "Summary: 0 packages finished")


def test_a_cpp_package_from_a_template(at_home: Room) -> None:
    """Its CMakeLists.txt asks for ament_lint_auto when it is built."""
    terminal = at_home.terminal()
    terminal.run(f"cd ~/{WORKSPACE}/src")
    terminal.run("ros2 pkg create lamps --build-type ament_cmake --node-name lamp --dependencies std_msgs")
    assert "find_package(ament_lint_auto REQUIRED)" in terminal.run("cat lamps/CMakeLists.txt")
    terminal.run("cd ..")
    assert "Summary: 1 package finished" in terminal.run("colcon build")
    terminal.run("source install/setup.bash")
    assert terminal.run("ros2 run lamps lamp").text == "hello world lamps package\n"


def test_ctrl_c_while_colcon_builds(at_home: Room) -> None:
    terminal = at_home.terminal()
    create(terminal, LAMPS)
    terminal.begin("colcon build")
    terminal.see("Starting >>> lamps")
    assert "Summary: " in terminal.ctrl_c(code=2)
    terminal.run("colcon build && source install/setup.bash")
    assert terminal.run("ros2 run lamps lamp").text == "Hi from lamps.\n"
