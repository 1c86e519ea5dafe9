"""`ros2 component standalone`: a container of its own for one component."""

from __future__ import annotations

import contextlib
import signal
import subprocess
import uuid
from argparse import ArgumentParser, Namespace

from ros2cli.components import add_component_arguments, load
from ros2cli.errors import CommandError
from ros2cli.graph import add_graph_arguments


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    add_component_arguments(parser)
    text = "Name of the standalone container node to be run"
    parser.add_argument("-c", "--container-node-name", default=_name(), help=text)


def main(args: Namespace) -> int:
    from ros2cli.commands.running.bound import binding
    from ros2cli.node import own_node
    from ros2cli.verbs.pkg.installed import executables

    programs = {path.name: path for path in executables("rclcpp_components")}
    if "component_container" not in programs:
        raise CommandError("No component container node found!")
    words = ["--ros-args", "-r", f"__node:={args.container_node_name}"]
    container = subprocess.Popen([programs["component_container"], *words], preexec_fn=binding())
    try:
        with own_node(args) as node:
            load(node, f"/{args.container_node_name}", args)
    except CommandError as error:
        print(f"{error}, interrupting container node")
        container.send_signal(signal.SIGINT)
    except KeyboardInterrupt:
        pass  # the container has heard it, too
    return _ended(container)


def _name() -> str:
    return f"standalone_container_{uuid.uuid4().hex[:12]}"


def _ended(container: subprocess.Popen[bytes]) -> int:
    """Its exit code. Ctrl+C reaches it as well, and it ends by itself."""
    while container.returncode is None:
        with contextlib.suppress(KeyboardInterrupt):
            container.wait()
    return container.returncode
