"""A workspace with the tutorial's packages, as colcon leaves it, and the command that finds them."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.underlay.runtime.captured import capture
from tests.underlay.runtime.command import SOLUTIONS, Ros2, ros2_command

NODES = "python_package_with_a_node"
INTERFACES = "package_with_interfaces"
_SCRIPT = "#!/usr/bin/env python3\nfrom {package}.{name} import main\nmain()\n"
_XML_HEAD = '<?xml version="1.0"?>\n<?xml-model href="package_format3.xsd"?>\n'


@pytest.fixture(scope="session")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What `colcon build` makes of the tutorial's packages, as far as the ament index goes."""
    workspace = tmp_path_factory.mktemp("workspace")
    _install_nodes(workspace)
    _install_interfaces(workspace)
    install(workspace, "the_simplest_python_package")
    return workspace


@pytest.fixture
def ros2(workspace: Path, tmp_path: Path) -> Ros2:
    """The command, in an empty folder."""
    # Chapter after chapter goes on with the same package.
    source = max(SOLUTIONS.glob(f"*/ros2_tutorial_workspace/src/{NODES}"))
    return ros2_command(tmp_path, workspace, [source])


def install(workspace: Path, package: str) -> Path:
    """Make a package known to the ament index; its prefix."""
    prefix = workspace / "install" / package
    (prefix / "share" / package).mkdir(parents=True)
    _marker(prefix, "packages", package, "")
    return prefix


def script(prefix: Path, name: str, text: str) -> None:
    """Make an executable of the package."""
    file = prefix / "lib" / prefix.name / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    file.chmod(0o755)


def _install_nodes(workspace: Path) -> None:
    prefix = install(workspace, NODES)
    (prefix / "share" / NODES / "package.xml").write_text(_XML_HEAD + capture("pkg_xml").stdout)
    for name in ("sample_python_node", "print_forever_node"):
        script(prefix, name, _SCRIPT.format(package=NODES, name=name))


def _install_interfaces(workspace: Path) -> None:
    prefix = install(workspace, INTERFACES)
    texts = {
        "msg/AmazingQuote.msg": "# A quote\nint32 id # which\nstring quote\n\nstring philosopher_name\n",
        "srv/WhatIsThePoint.srv": (
            "# WhatIsThePoint.srv from https://ros2-tutorial.readthedocs.io\n"
            "# Receives an AmazingQuote and returns what is the point\n"
            "AmazingQuote quote\n---\ngeometry_msgs/Point point\n"
        ),
    }
    for name, text in texts.items():
        (prefix / "share" / INTERFACES / name).parent.mkdir()
        (prefix / "share" / INTERFACES / name).write_text(text)
    _marker(prefix, "rosidl_interfaces", INTERFACES, "\n".join(texts))


def _marker(prefix: Path, kind: str, package: str, content: str) -> None:
    file = prefix / "share/ament_index/resource_index" / kind / package
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(content)
