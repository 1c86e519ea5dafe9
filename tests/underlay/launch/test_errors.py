"""What is wrong with a launch file is told in the words of the real launch, or better ones; exit code 1."""

from __future__ import annotations

import pytest

from tests.underlay.launch.machine import Launcher

TOLD = "[ERROR] [launch]: Caught exception in launch (see debug for traceback): "
SEVERAL = TOLD + "Caught multiple exceptions when trying to load file of format [py]:"
NO_FRONTEND = (
    " - InvalidFrontendLaunchFileError: The launch file may have a syntax error, or its format is unknown"
)
NODE = "Node(package='telling', executable='tell', output='screen', {})"

# The whole file: what is told of it.
FILES = {
    "import nosuchmodule\n": "ModuleNotFoundError: No module named 'nosuchmodule'",
    "x = 1\n": (
        "InvalidPythonLaunchFileError: launch file at '<file>' does not contain the required function "
        "'generate_launch_description()'"
    ),
    "def generate_launch_description():\nreturn 1\n": (
        "IndentationError: expected an indented block after function definition on line 1 "
        "(test_launch.py, line 2)"
    ),
    "def generate_launch_description(x):\n    return 1\n": (
        "TypeError: generate_launch_description() missing 1 required positional argument: 'x'"
    ),
    "def generate_launch_description():\n    raise KeyError('oh')\n": "KeyError: 'oh'",
    "def generate_launch_description():\n    pass\n": (
        "InvalidPythonLaunchFileError: launch file at '<file>': generate_launch_description() must return a "
        "LaunchDescription, but it returned nothing (None)"
    ),
    "def generate_launch_description():\n    return [1]\n": (
        "InvalidPythonLaunchFileError: launch file at '<file>': generate_launch_description() must return a "
        "LaunchDescription, but it returned [1] (list)"
    ),
}
# Descriptions that are refused when the file is loaded.
LOADED = {
    "'x'": "TypeError: LaunchDescription expected a list of actions, but found 'x' (str) in it",
    "Node(package='telling')": (
        "TypeError: Node.__init__() missing 1 required keyword-only argument: 'executable'"
    ),
    NODE.format("pkg='x'"): "TypeError: Action.__init__() got an unexpected keyword argument 'pkg'",
    NODE.format("parameters={'a': 1}"): "TypeError: Expecting list of parameters, got {'a': 1}",
    NODE.format("parameters=[{'a': None}]"): "TypeError: Unexpected type for parameter value None",
    NODE.format("remappings=['a']"): ("TypeError: expected a remapping as a pair ('from', 'to'), got 'a'"),
    "LogInfo('x')": "TypeError: LogInfo.__init__() takes 1 positional argument but 2 were given",
    "DeclareLaunchArgument('a', default_value=3)": (
        "TypeError: Failed to normalize given item of type '<class 'int'>', when only 'str' or "
        "'launch.Substitution' were expected."
    ),
    "DeclareLaunchArgument('a', default_value='x', choices=['y'])": (
        'RuntimeError: Provided default_value "x" is not in provided choices "[\'y\']".'
    ),
    "RegisterEventHandler(OnProcessExit(target_action='x', on_exit=[]))": (
        "ValueError: expected an 'ExecuteLocal' action or a function, got 'x'"
    ),
    "EmitEvent(event='x')": "RuntimeError: EmitEvent() expected an event instance, got 'x'.",
}
# Descriptions that go wrong when its turn comes.
VISITED = {
    "LogInfo(msg=LaunchConfiguration('nosuch'))": "launch configuration 'nosuch' does not exist",
    "LogInfo(msg='x', condition=IfCondition('x'))": (
        "invalid condition expression, expected one of 'true, 1' (true) or 'false, 0' (false), but got 'x'"
    ),
    "ExecuteProcess(cmd=['true'], output='scren')": (
        "'scren' is not a valid standard output config i.e. 'screen', 'log' or 'both'"
    ),
    "ExecuteProcess(cmd=['true'], sigterm_timeout='x')": "could not convert string to float: 'x'",
    NODE.format("name='a/b'"): (
        "the node name 'a/b' must not contain a slash: that is what namespace= is for"
    ),
    "LifecycleNode(package='a', executable='b', name='c', namespace='')": (
        "launch_ros.actions.LifecycleNode is not offered here: managed nodes need an installed ROS 2 "
        "(sudo apt install ros-jazzy-launch-ros)"
    ),
    "RosTimer(period=1.0, actions=[])": (
        "launch_ros.actions.RosTimer is not offered here: use launch.actions.TimerAction, or install ROS 2 "
        "(sudo apt install ros-jazzy-launch-ros)"
    ),
}
FRONTENDS = {
    "<launch><node pkg='a'/></launch>": (
        "Attribute 'exec' of type '<class 'str'>' not found in Entity 'node'"
    ),
    "<launch><nod pkg='a'/></launch>": "Unrecognized entity of the type: nod",
    "<launch>\n<log message='x'>\n</launch>": "mismatched tag: line 3, column 2",
    "<launch><log message='$(nosuch a)'/></launch>": "Unknown substitution: nosuch",
    "<launch><log message='$(var a'/></launch>": "no ')' ends the substitution '$(var a'",
    "<lunch/>": "Expected 'launch' as root tag",
    "<launch><log message='a' foo='b'/></launch>": "Unexpected attribute(s) found in `log`: {'foo'}",
    "<launch><arg name='a'><x/></arg></launch>": "Unexpected nested entity(ies) found in `arg`: {'x'}",
    "<launch><log message='a' if='1' unless='1'/></launch>": (
        "if and unless conditions can't be used simultaneously"
    ),
    "launch:\n- node: {pkg: a}\n": "Attribute 'exec' of type '<class 'str'>' not found in Entity 'node'",
    "launch:\n- log: {message: a, foo: b}\n": "Unexpected key(s) found in `log`: ['foo']",
    "a: 1\n": "Expected 'launch' as root tag",
    "launch:\n- arg: {name: a}\n  log: {message: a}\n": (
        "Subentities of `launch` must be dictionaries with only one key: "
        "{'arg': {'name': 'a'}, 'log': {'message': 'a'}}"
    ),
}


@pytest.mark.parametrize("source", FILES)
def test_a_file(launcher: Launcher, source: str) -> None:
    path = launcher.file(source)
    answer = launcher(path)
    # What comes last says why it is not a launch file in YAML, either.
    assert answer.said[:-1] == [SEVERAL, " - " + FILES[source].replace("<file>", str(path))]
    assert (answer.code, answer.stderr) == (1, "")


@pytest.mark.parametrize("entity", LOADED)
def test_a_description(launcher: Launcher, entity: str) -> None:
    answer = launcher.run(entity)
    assert answer.said == [SEVERAL, f" - {LOADED[entity]}", NO_FRONTEND]
    assert (answer.code, answer.stderr) == (1, "")


@pytest.mark.parametrize("entity", VISITED)
def test_an_entity(launcher: Launcher, entity: str) -> None:
    answer = launcher.run(f"LogInfo(msg='before'), {entity}, LogInfo(msg='not reached')")
    assert answer.said == ["[INFO] [launch.user]: before", TOLD + VISITED[entity]]
    assert (answer.code, answer.stderr) == (1, "")


def test_what_is_refused_when_the_file_is_loaded_is_one_line_too(launcher: Launcher) -> None:
    answer = launcher.run(
        "RegisterEventHandler(OnStateTransition(goal_state='active', entities=[]))",
        before="from launch_ros.event_handlers import OnStateTransition\n",
    )
    assert answer.said == [
        f"{TOLD}launch_ros.event_handlers.OnStateTransition is not offered here: managed nodes need an "
        "installed ROS 2 (sudo apt install ros-jazzy-launch-ros)"
    ]
    assert answer.code == 1


@pytest.mark.slow
@pytest.mark.parametrize("source", FRONTENDS)
def test_xml_and_yaml(launcher: Launcher, source: str) -> None:
    suffix = "xml" if source.startswith("<") else "yaml"
    answer = launcher(launcher.file(source, f"test_launch.{suffix}"))
    assert answer.said == [
        f"{TOLD}Caught exception when trying to load file of format [{suffix}]: {FRONTENDS[source]}"
    ]
    assert (answer.code, answer.stderr) == (1, "")


def test_yaml_that_is_none_names_file_and_line(launcher: Launcher) -> None:
    path = launcher.file("launch:\n- log: [\n", "test_launch.yaml")
    assert f'in "{path}", line 3, column 1' in launcher(path).stdout


@pytest.mark.parametrize("tag", ["node_container", "load_composable_node", "lifecycle_node", "ros_timer"])
def test_tags_that_are_not_offered(launcher: Launcher, tag: str) -> None:
    answer = launcher(launcher.file(f"<launch><{tag} a='b'><x y='z'/></{tag}></launch>", "x_launch.xml"))
    (line,) = answer.said
    assert line.startswith(f"{TOLD}<{tag}> is not offered here: ") and "ros-jazzy-launch-ros" in line
    assert answer.code == 1


@pytest.mark.parametrize(
    "include", ["'/nosuch/x_launch.py'", "[FindPackageShare('telling'), '/x_launch.py']"]
)
def test_an_included_file_that_is_not_there(launcher: Launcher, include: str) -> None:
    answer = launcher.run(f"IncludeLaunchDescription({include})")
    assert answer.said[0] == SEVERAL
    assert answer.said[1].startswith(" - FileNotFoundError: [Errno 2] No such file or directory: '/")
    assert (answer.code, answer.stderr) == (1, "")


def test_a_mistake_in_an_included_file(launcher: Launcher) -> None:
    launcher.file("def generate_launch_description()\n    pass\n", "inner_launch.py")
    answer = launcher.run("IncludeLaunchDescription([ThisLaunchFileDir(), '/inner_launch.py'])")
    assert answer.said[1] == " - SyntaxError: expected ':' (inner_launch.py, line 1)"


def test_programs_that_cannot_be_started(launcher: Launcher) -> None:
    """The launch goes on without them, as the real one does."""
    script = launcher.file("import rclpy\n", "script")
    answer_of = "exception occurred while executing process: "
    plain = launcher.run(f"ExecuteProcess(cmd=['{script}']), ExecuteProcess(cmd=['echo', 'on'])")
    assert (
        f"[ERROR] [script-1]: {answer_of}PermissionError: [Errno 13] Permission denied: '{script}'"
        in plain.said
    )
    script.chmod(0o755)
    answer = launcher.run(
        f"ExecuteProcess(cmd=['{script}']), ExecuteProcess(cmd=['true'], cwd='/nosuch'),"
        "ExecuteProcess(cmd=['echo', 'on'], output='screen')"
    )
    assert f"[ERROR] [script-1]: {answer_of}OSError: [Errno 8] Exec format error: '{script}'" in answer.said
    assert (
        f"[ERROR] [true-2]: {answer_of}FileNotFoundError: [Errno 2] No such file or directory: '/nosuch'"
        in (answer.said)
    )
    assert answer.of("echo-3") == ["on"]
    assert (answer.code, answer.stderr) == (0, "")
