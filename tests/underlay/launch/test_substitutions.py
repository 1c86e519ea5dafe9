"""Every substitution gives its text, or says why it has none."""

from __future__ import annotations

import pytest

from tests.underlay.launch.machine import Launcher

TEXTS = {
    "TextSubstitution(text='x')": "x",
    "['a', TextSubstitution(text='b')]": "ab",
    "LaunchConfiguration(['a', 'rg'])": "value",
    "LaunchConfiguration('none', default=['d', LaunchConfiguration('arg')])": "dvalue",
    "LaunchConfiguration('none', default=5)": "5",
    "EnvironmentVariable('VARIABLE')": "from outside",
    "EnvironmentVariable('NOSUCH', default_value='d')": "d",
    "PathJoinSubstitution(['/a', ['b', 'c'], LaunchConfiguration('arg')])": "/a/bc/value",
    "PathJoinSubstitution(['/a']) / 'b'": "/a/b",
    "PythonExpression(['2 * ', '21'])": "42",
    "PythonExpression(['\\'', LaunchConfiguration('arg'), '\\' == \\'value\\''])": "True",
    "PythonExpression('floor(math.pi)')": "3",
    "PythonExpression('os.sep', ['os'])": "/",
    "Command(['printf ', 'hi'])": "hi",
    "Command('sh -c \"echo -n a; echo -n b >&2\"', on_stderr='ignore')": "a",
    "Command('sh -c \"printf a; printf b >&2\"', on_stderr='capture')": "ab",
    "FindExecutable(name='sh')": "/bin/sh",
    "FileContent([ThisLaunchFileDir(), '/content'])": "content",
    "StringJoinSubstitution(['a', ['b', 'c']], delimiter='-')": "a-bc",
    "NotSubstitution('false')": "true",
    "AndSubstitution('true', '0')": "false",
    "OrSubstitution('True', 'false')": "true",
    "AnySubstitution('false', 'false', '1')": "true",
    "AllSubstitution('true', 'false')": "false",
    "EqualsSubstitution(LaunchConfiguration('arg'), 'value')": "true",
    "EqualsSubstitution('1', '1.0')": "true",
    "EqualsSubstitution(True, 'true')": "true",
    "NotEqualsSubstitution('a', 'b')": "true",
    "IfElseSubstitution('true', 'a', 'b')": "a",
    "IfElseSubstitution(EqualsSubstitution('a', 'b'), if_value='a', else_value='b')": "b",
}
FAILURES = {
    "LaunchConfiguration('none')": "launch configuration 'none' does not exist",
    "EnvironmentVariable('NOSUCH')": "environment variable 'NOSUCH' does not exist",
    "FindExecutable(name='nosuch')": "executable 'nosuch' not found on the PATH",
    "Command('false')": "executed command failed. Command: false",
    "Command('nosuch-program')": "file not found: [Errno 2] No such file or directory: 'nosuch-program'",
    "Command('sh -c \"echo -n b >&2\"')": (
        'executed command showed stderr output. Command: sh -c "echo -n b >&2"'
    ),
    "FindPackageShare('nosuch_package')": "package 'nosuch_package' not found, searching: [",
    "PythonExpression('1 +')": "invalid syntax",
}


def test_texts(launcher: Launcher) -> None:
    launcher.file("content", "content")
    entities = ", ".join(f"LogInfo(msg={expression})" for expression in TEXTS)
    answer = launcher.run(entities, "arg:=value", VARIABLE="from outside")
    usual = [text.replace("/usr/bin/sh", "/bin/sh") for text in answer.logged]
    assert dict(zip(TEXTS, usual, strict=True)) == TEXTS


@pytest.mark.parametrize("expression", FAILURES)
def test_failures(launcher: Launcher, expression: str) -> None:
    answer = launcher.run(f"LogInfo(msg={expression}), LogInfo(msg='not reached')")
    told = "[ERROR] [launch]: Caught exception in launch (see debug for traceback): "
    assert answer.said[0].replace('"package', "package").startswith(told + FAILURES[expression])
    assert (answer.code, answer.logged, answer.stderr) == (1, [], "")


def test_anonymous_names(launcher: Launcher) -> None:
    one, again, other = launcher.run(
        "LogInfo(msg=AnonName('a')), LogInfo(msg=AnonName('a')), LogInfo(msg=AnonName('b'))"
    ).logged
    assert one == again and one.startswith("a_") and other.startswith("b_")
