import launch
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.substitutions import EnvironmentVariable, FindExecutable, LaunchConfiguration


def generate_launch_description():
    sh = FindExecutable(name="sh")
    return LaunchDescription(
        [
            launch.actions.SetEnvironmentVariable("BASE", "base"),
            ExecuteProcess(
                cmd=[sh, "-c", "echo $BASE $EXTRA; echo error >&2"],
                name="both_streams",
                additional_env={"EXTRA": ["e", EnvironmentVariable("BASE")]},
                output={"both": ["screen", "log", "own_log"]},
            ),
            ExecuteProcess(cmd=["/usr/bin/env"], env={"ONLY": "this"}, output="screen", name="clean"),
            ExecuteProcess(cmd=["pwd"], cwd="/", output="screen"),
            ExecuteProcess(
                cmd=[["echo ", LaunchConfiguration("word", default="w"), " > /dev/null && echo shell"]],
                shell=True,
                output="screen",
                name="through_shell",
            ),
            ExecuteProcess(
                cmd=["printf", "%s|", "a b", "c"], prefix="env X=1", output="screen", log_cmd=True
            ),
            ExecuteProcess(cmd=["sh", "-c", "exit 7"], name="fails", output="own_log"),
            ExecuteProcess(cmd=["sh", "-c", "kill -SEGV $$"], name="crashes"),
            ExecuteProcess(
                cmd=["echo", "formed"], output="screen", output_format="<{line}>", emulate_tty=True
            ),
            ExecuteProcess(cmd=["sh", "-c", "echo silent; echo seen >&2"], name="quiet", output="log"),
            ExecuteProcess(
                cmd=["sh", "-c", "echo first; sleep 0.1; echo second"],
                name="held",
                output="screen",
                cached_output=True,
            ),
        ]
    )
