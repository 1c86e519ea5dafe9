"""Launch files in XML and YAML: what the cases do not show."""

from __future__ import annotations

import pytest

from tests.underlay.launch.machine import Launcher

# What an attribute says, and its value, with robot:=r2.
TEXTS = {
    "plain $ text, 5 $": "plain $ text, 5 $",
    r"\$(var robot) \n": r"$(var robot) \n",
    "$(var robot)$(var robot)": "r2r2",
    "$( var  robot )": "r2",
    "$(var none 'a b')": "a b",
    "$(var none $(var robot)/x)": "r2/x",
    "$(var none '')|": "|",
    "$(env NO $(env NEITHER deep))": "deep",
    "$(eval 1 + int('$(var number)'))": "4",
    "$(eval '1 + $(var number)')": "4",
    "$(eval &quot;'$(var robot)' == 'r2'&quot;)": "True",
    "$(eval '$(var robot)' == 'r2')": "True",
    "$(eval 'os.sep' 'os')": "/",
    "$(command 'printf %s-%s a b')": "a-b",
    "$(command printf x)": "x",
    "$(or false $(equals $(var robot) r2))": "true",
    "$(string-join - a b)": "a-b",
    "$(path-join /a b $(var robot))": "/a/b/r2",
    "$(find-exec true)": "/bin/true",
}
# An attribute `cmd`: the words that the program gets, which prints each with a bar after it.
COMMANDS = {
    "a b  c": "a|b|c|",
    "'a b' c": "a b|c|",
    "a$(var robot)b c": "ar2b|c|",
    "'a $(var none 'x y') b'": "a x y b|",
    "--name:=$(var robot) ''": "--name:=r2||",
    r"a\ b 'c\n' &quot;\&quot;d&quot; \$e": r'a b|c\n|"d|$e|',
}


def _xml(body: str) -> str:
    return f"<launch><arg name='robot' default='r2'/><arg name='number' default='3'/>{body}</launch>"


def _attribute(text: str) -> str:
    return '"' + text + '"'


def test_substitutions_in_texts(launcher: Launcher) -> None:
    body = "".join(f"<log message={_attribute(text)}/>" for text in TEXTS)
    answer = launcher(launcher.file(_xml(body), "test_launch.xml"))
    said = [line.replace("/usr/bin/", "/bin/") for line in answer.logged]
    assert dict(zip(TEXTS, said, strict=True)) == TEXTS


def test_words_of_command_lines(launcher: Launcher) -> None:
    body = "".join(
        f"<executable name='p' output='screen' cmd={_attribute('printf %s| ' + text)}/>" for text in COMMANDS
    )
    answer = launcher(launcher.file(_xml(body), "test_launch.xml"))
    said = [answer.of(f"p-{number}")[0] for number in range(1, len(COMMANDS) + 1)]
    assert dict(zip(COMMANDS, said, strict=True)) == COMMANDS


def test_a_quote_that_is_not_closed(launcher: Launcher) -> None:
    answer = launcher(launcher.file(_xml('<executable cmd="a \'b"/>'), "test_launch.xml"))
    assert answer.said[0].endswith("when trying to load file of format [xml]: No closing quotation")
    assert answer.code == 1


def test_a_file_of_a_package(launcher: Launcher) -> None:
    answer = launcher("telling", "inner_launch.xml", "robot_name:=r2")
    assert answer.logged[0].startswith("inner xml: r2 in ")
    shown = launcher("telling", "inner_launch.xml", "-s").stdout
    assert shown == (
        "Arguments (pass arguments as '<name>:=<value>'):\n\n    'robot_name':\n        no description given"
    )


def test_a_missing_argument_is_told_before_anything_starts(launcher: Launcher) -> None:
    (line,) = launcher("telling", "inner_launch.xml").said
    assert line.endswith(
        "Included launch description missing required argument 'robot_name' "
        "(description: 'no description given'), given: []"
    )


@pytest.mark.parametrize("source", ["<launch><log message='x'/></launch>", "launch: [log: {message: x}]"])
def test_a_name_that_tells_nothing(launcher: Launcher, source: str) -> None:
    assert launcher(launcher.file(source, "robot.launch")).logged == ["x"]


def test_from_python(launcher: Launcher) -> None:
    launcher.file("<launch><log message='$(var a)'/></launch>", "one.txt")
    launcher.file("launch: [log: {message: $(var a)}]", "two.txt")
    answer = launcher.run(
        "*[IncludeLaunchDescription(source([ThisLaunchFileDir(), name]), launch_arguments=[('a', name)])"
        " for source, name in ((XMLLaunchDescriptionSource, '/one.txt'),"
        " (YAMLLaunchDescriptionSource, '/two.txt'))]",
        before="from launch_xml.launch_description_sources import XMLLaunchDescriptionSource\n"
        "from launch_yaml.launch_description_sources import YAMLLaunchDescriptionSource\n",
    )
    assert answer.logged == ["/one.txt", "/two.txt"]


EXPOSED = """
from launch.frontend import expose_action, expose_substitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

@expose_substitution('upper')
class Upper(Substitution):
    def __init__(self, text):
        self.text = text
    @classmethod
    def parse(cls, data):
        return cls, {'text': data[0]}
    def perform(self, context):
        return perform_substitutions(context, self.text).upper()

@expose_action('greet')
class Greet(Action):
    def __init__(self, whom, loud=False, **kwargs):
        super().__init__(**kwargs)
        self.whom, self.loud = whom, loud
    @classmethod
    def parse(cls, entity, parser):
        _, kwargs = super().parse(entity, parser)
        kwargs['whom'] = parser.parse_substitution(entity.get_attr('whom'))
        kwargs['loud'] = entity.get_attr('loud', data_type=bool, optional=True)
        return cls, kwargs
    def execute(self, context):
        return [LogInfo(msg=['hello ', *self.whom, '!' if self.loud else ''])]
"""


def test_what_packages_expose(launcher: Launcher) -> None:
    launcher.file(
        "<launch><greet whom='$(upper $(var x))' loud='1'/><greet whom='y' if='0'/></launch>", "i.xml"
    )
    answer = launcher.run(
        "IncludeLaunchDescription([ThisLaunchFileDir(), '/i.xml'], launch_arguments=[('x', 'me')])",
        before=EXPOSED,
    )
    assert answer.logged == ["hello ME!"]


def test_values_of_a_type(launcher: Launcher) -> None:
    """`respawn_max_retries` is to be a whole number."""
    path = launcher.file(_xml("<executable cmd='true' respawn_max_retries='x'/>"), "test_launch.xml")
    told = "Attribute 'respawn_max_retries' of Entity 'executable' is expected to be of type '<class 'int'>'"
    assert launcher(path).said[0].endswith(f"{told}, got 'x'")
