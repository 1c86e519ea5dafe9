"""What a node is started with."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest
import yaml

from tests.underlay.launch.machine import Answer, Launcher


def _words(answer: Answer, process: str = "tell-1") -> list[str]:
    """Its arguments, without the names of temporary files."""
    words = [line.removeprefix("arg ") for line in answer.of(process) if line.startswith("arg ")]
    return ["<file>" if "launch_params_" in word else word for word in words]


def _parameters(answer: Answer, process: str = "tell-1") -> object:
    lines = [line.removeprefix("file ") for line in answer.of(process) if line.startswith("file ")]
    return yaml.safe_load("\n".join(lines))


def _node(more: str, around: str = "{}") -> str:
    return around.format(f"Node(package='telling', executable='tell', output='screen', {more})")


def test_everything_at_once(launcher: Launcher) -> None:
    answer = launcher.run(
        _node(
            "name=['na', 'me'], namespace=LaunchConfiguration('ns'), arguments=['-x', ['y', '1']],"
            "ros_arguments=['--log-level', 'debug'], parameters=[{'a': 1}],"
            "remappings=[('chatter', 'talk'), ('x', LaunchConfiguration('ns'))]"
        ),
        "ns:=space",
    )
    assert _words(answer) == [
        "-x", "y1", "--ros-args", "--log-level", "debug", "-r", "__node:=name", "-r", "__ns:=/space",
        "--params-file", "<file>", "-r", "chatter:=talk", "-r", "x:=space",
    ]  # fmt: skip
    assert _parameters(answer) == {"/space/name": {"ros__parameters": {"a": 1}}}
    assert not list((launcher.cwd.parent / "tmp").iterdir())


def test_types_of_parameters(launcher: Launcher) -> None:
    answer = launcher.run(
        _node(
            """parameters=[{
                'bool': True, 'int': 3, 'float': 2.0, 'text': 'on', 'number as text': '5',
                'list': [1, 2], 'mixed': [1, 2.5], 'texts': ['y', 'n'], 'tuple': (1.5, 2.5),
                'nested': {'deep': {'er': 'x'}, 'list': ['a']},
                'guessed bool': LaunchConfiguration('flag'), 'guessed int': LaunchConfiguration('n'),
                'guessed list': LaunchConfiguration('list'),
                'joined': [LaunchConfiguration('n'), '/', 'x'],
                'several': [[LaunchConfiguration('n')], ['b', 'c']],
                'told': ParameterValue(LaunchConfiguration('n'), value_type=str),
                'told float': ParameterValue(LaunchConfiguration('n'), value_type=float),
                LaunchConfiguration('name'): 'by substitution',
            }]"""
        ),
        "flag:=true", "n:=7", "list:=[a, b]", "name:=dynamic",
    )  # fmt: skip
    assert _parameters(answer) == {
        "/**": {
            "ros__parameters": {
                "bool": True, "int": 3, "float": 2.0, "text": "on", "number as text": "5",
                "list": [1, 2], "mixed": [1.0, 2.5], "texts": ["y", "n"], "tuple": [1.5, 2.5],
                "nested.deep.er": "x", "nested.list": ["a"],
                "guessed bool": True, "guessed int": 7, "guessed list": ["a", "b"],
                "joined": "7/x", "several": ["7", "bc"], "told": "7", "told float": 7.0,
                "dynamic": "by substitution",
            }
        }
    }  # fmt: skip


def test_parameter_files(launcher: Launcher) -> None:
    plain = launcher.file("/**:\n  ros__parameters:\n    a: 1\n", "plain.yaml")
    launcher.file(
        "/**:\n  ros__parameters:\n    a: $(var a)\n    b: $(env HOME)/$(var $(var which))\n", "substs.yaml"
    )
    answer = launcher.run(
        _node(
            "parameters=[PathJoinSubstitution([ThisLaunchFileDir(), 'plain.yaml']), {'own': 'x'},"
            "ParameterFile([ThisLaunchFileDir(), '/substs.yaml'], allow_substs=True), 'nosuch.yaml']"
        ),
        "a:=5",
        "which:=a",
    )
    assert _words(answer) == [
        "--ros-args", "--params-file", str(plain), "--params-file", "<file>", "--params-file", "<file>",
    ]  # fmt: skip
    assert f"file     b: {launcher.home}/5" in answer.of("tell-1")
    assert "[WARNING] [launch_ros]: Parameter file path is not a file: nosuch.yaml" in answer.said


def test_namespaces(launcher: Launcher) -> None:
    answer = launcher.run(
        "GroupAction([PushRosNamespace('outer'), "
        + _node("name='a'")
        + ", GroupAction([PushROSNamespace('inner'), "
        + _node("name='b', namespace='own', parameters=[{'x': 1}]")
        + "]), "
        + _node("name='c', namespace='/abs'")
        + "]), "
        + _node("name='d'")
    )
    words = [" ".join(_words(answer, f"tell-{i}")) for i in (1, 2, 3, 4)]
    assert words == [
        "--ros-args -r __node:=a -r __ns:=/outer",
        "--ros-args -r __node:=b -r __ns:=/outer/inner/own --params-file <file>",
        "--ros-args -r __node:=c -r __ns:=/abs",
        "--ros-args -r __node:=d",
    ]
    assert _parameters(answer, "tell-2") == {"/outer/inner/own/b": {"ros__parameters": {"x": 1}}}


def test_for_all_nodes(launcher: Launcher) -> None:
    answer = launcher.run(
        "SetParameter('all', 1), GroupAction(["
        "SetParameter('rate', 5), SetParameter(name='text', value='5'), SetUseSimTime(True),"
        "SetRemap('a', 'b'), SetParametersFromFile('p.yaml'),"
        + _node(
            "remappings=[('c', 'd')], parameters=[launch_ros.parameter_descriptions.Parameter('z', [1, 2])]"
        )
        + "]), "
        + _node("")
    )
    assert _words(answer) == [
        "--ros-args", "-p", "all:=1", "-p", "rate:=5", "-p", "text:='5'", "-p", "use_sim_time:=true",
        "-p", "z:=[1, 2]", "-r", "a:=b", "-r", "c:=d",
    ]  # fmt: skip
    assert _words(answer, "tell-2") == ["--ros-args", "-p", "all:=1"]


def test_names_of_processes_and_twins(launcher: Launcher) -> None:
    answer = launcher.run(
        _node("name='twin', namespace='/', exec_name='first'") + "," + _node("name='twin', namespace='/'")
    )
    assert _words(answer, "first-1") == ["--ros-args", "-r", "__node:=twin", "-r", "__ns:=/"]
    assert (
        "[WARNING] [launch_ros]: there are now at least 2 nodes with the name /twin created within this "
        "launch context"
    ) in answer.said


def test_a_program_without_a_package(launcher: Launcher) -> None:
    program = launcher.workspace / "install/telling/lib/telling/tell"
    answer = launcher.run(f"Node(executable='{program}', output='screen', respawn=False)")
    assert _words(answer) == ["--ros-args"]


def test_where_packages_lie(launcher: Launcher) -> None:
    answer = launcher.run(
        "LogInfo(msg=FindPackageShare('telling')), LogInfo(msg=FindPackagePrefix(['tell', 'ing'])),"
        "LogInfo(msg=PathJoinSubstitution([FindPackageShare('telling'), 'launch', 'x.py']))"
    )
    prefix = Path(launcher.workspace) / "install" / "telling"
    share = f"{prefix}/share/telling"
    assert answer.logged == [share, str(prefix), f"{share}/launch/x.py"]


def test_an_unknown_executable(launcher: Launcher) -> None:
    answer = launcher.run("Node(package='telling', executable='nosuch')")
    folder = launcher.workspace / "install/telling/lib/telling"
    assert answer.said == [
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): "
        f"executable 'nosuch' not found on the libexec directory '{folder}' "
    ]
    assert (answer.code, answer.stderr) == (1, "")


def test_a_value_that_is_no_yaml(launcher: Launcher) -> None:
    answer = launcher.run(_node("parameters=[{'a': LaunchConfiguration('v')}]"), "v:=[unclosed")
    assert (
        "Unable to parse the value of parameter a as yaml. If the parameter is meant to be a string"
        in answer.stdout
    )
    assert answer.code == 1


NODE = """#!{python}
import rclpy
import sys
from rclpy.node import Node

rclpy.init()
node = Node(
    "original", allow_undeclared_parameters=True, automatically_declare_parameters_from_overrides=True
)
print(node.get_fully_qualified_name(), node.resolve_topic_name("a"), file=sys.stderr)
for name in ("flag", "number", "text", "texts", "nested.x", "rate", "quoted", "unicode"):
    print(name, repr(node.get_parameter(name).value), file=sys.stderr)
timer = node.create_timer(0.0, lambda: (timer.cancel(), print("ready", file=sys.stderr, flush=True)))
try:
    rclpy.spin(node)  # rclpy complains of a signal that comes while it makes its executor
except KeyboardInterrupt:
    pass
"""


@pytest.mark.slow
def test_a_real_node_gets_what_was_meant(launcher: Launcher) -> None:
    program = launcher.file(NODE.format(python=launcher.python), "node")
    program.chmod(0o755)
    path = launcher.description(
        f"""
        PushRosNamespace('space'), SetParameter('rate', 2.0),
        Node(executable='{program}', name='renamed', remappings=[('a', '/b')], sigterm_timeout='60',
             parameters=[{{
            'flag': LaunchConfiguration('flag', default='true'), 'number': 3, 'text': 'y',
            'texts': ['n', '1'], 'nested': {{'x': 1.5}}, 'quoted': "it's: {{}}", 'unicode': 'Größe'}}]),
        """
    )
    with launcher.started(path) as running:
        running.wait_for("ready")
        running.signal(signal.SIGINT)
        answer = running.finish()
    assert answer.of("node-1") == [
        "/space/renamed /b", "flag True", "number 3", "text 'y'", "texts ['n', '1']", "nested.x 1.5",
        "rate 2.0", "quoted \"it's: {}\"", "unicode 'Größe'", "ready",
    ]  # fmt: skip
    assert "process has finished cleanly" in answer.said[-1]


def test_a_script_of_another_python(launcher: Launcher, tmp_path: Path) -> None:
    """Its first line names a Python that cannot know the ROS of this one."""
    other = tmp_path / "python3"
    other.symlink_to("/bin/false")
    script = launcher.workspace / "install/telling/lib/telling/script"
    script.write_text(f"#!{other} -B\nimport sys\nprint(sys.executable, sys.flags.dont_write_bytecode)\n")
    script.chmod(0o755)
    answer = launcher.run("Node(package='telling', executable='script', prefix='env A=b', output='screen')")
    assert answer.of("script-1") == [f"{launcher.python} 1"]
    assert answer.said[0].endswith("does not know this ROS")
