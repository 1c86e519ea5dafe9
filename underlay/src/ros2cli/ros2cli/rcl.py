"""A node on rclpy's compiled part alone: the Python around it takes longer to import than a listing takes."""

from __future__ import annotations

import contextlib
import importlib
import importlib.util
import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

_EXTENSION = "rclpy._rclpy_pybind11"
_FOREVER = 0x7FFFFFFFFFFFFFFF
_USUAL = (("/parameter_events", "parameter_event"), ("/rosout", "log"))
_KEEP_LAST, _RELIABLE, _VOLATILE = 1, 1, 2


@dataclass(frozen=True)
class Handle:
    """What the functions of rclpy's compiled part want to have: themselves, a context and a node."""

    rcl: Any
    context: Any
    node: Any

    @property
    def name(self) -> str:
        return str(self.node.get_node_name())


def extension() -> Any:
    """rclpy's compiled part, without the Python package around it where that is not loaded yet."""
    if _EXTENSION in sys.modules:
        return sys.modules[_EXTENSION]
    pattern = "_rclpy_pybind11*.so"
    file = next((file for folder in sys.path for file in Path(folder, "rclpy").glob(pattern)), None)
    spec = importlib.util.spec_from_file_location(_EXTENSION, file) if file else None
    if spec is None or spec.loader is None:
        return importlib.import_module(_EXTENSION)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    sys.modules[_EXTENSION] = module
    return module


@contextlib.contextmanager
def quick_node(name: str = "") -> Iterator[Handle]:
    """A hidden node that looks at the graph and is gone again, with the two topics that every node has."""
    rcl = extension()
    context = rcl.Context([], domain_id())
    node = rcl.Node(name or hidden_name(), "", context, [], False, False)
    publishers = [
        rcl.Publisher(node, message_stub("rcl_interfaces", kind), topic, qos(rcl)) for topic, kind in _USUAL
    ]
    try:
        yield Handle(rcl, context, node)
    finally:
        for publisher in publishers:
            publisher.destroy_when_not_in_use()
        node.destroy_when_not_in_use()
        context.shutdown()


def hidden_name() -> str:
    return f"_ros2cli_{os.getpid()}"


def message_stub(package: str, message: str) -> type:
    """A class that names a message's type to rcl, without importing its Python code and numpy with it."""
    library = importlib.import_module(f"{package}.{package}_s__rosidl_typesupport_c")
    support = getattr(library, f"type_support_msg__msg__{message}")
    return type(type)("Type", (type,), {"_TYPE_SUPPORT": support})("Message", (), {})


def qos(rcl: Any) -> Any:
    """Reliable, for who listens now."""
    forever = rcl.rcl_duration_t(_FOREVER)
    return rcl.rmw_qos_profile_t(_KEEP_LAST, 1000, _RELIABLE, _VOLATILE, forever, forever, 0, forever, False)


def domain_id() -> int:
    value = os.environ.get("ROS_DOMAIN_ID", "")
    return int(value) if value.isdigit() else 0
