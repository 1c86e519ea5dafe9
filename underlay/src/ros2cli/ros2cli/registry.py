"""Every command and verb with its one line of help, so that `ros2 -h` imports none of them."""

from __future__ import annotations

COMMANDS = {
    "action": "Various action related sub-commands",
    "component": "Various component related sub-commands",
    "daemon": "Various daemon related sub-commands",
    "doctor": "Check ROS setup and other potential issues",
    "interface": "Show information about ROS interfaces",
    "launch": "Run a launch file",
    "lifecycle": "Various lifecycle related sub-commands",
    "multicast": "Various multicast related sub-commands",
    "node": "Various node related sub-commands",
    "param": "Various param related sub-commands",
    "pkg": "Various package related sub-commands",
    "run": "Run a package specific executable",
    "service": "Various service related sub-commands",
    "topic": "Various topic related sub-commands",
    "wtf": "Use `wtf` as alias to `doctor`",
}

# Answered, but not listed.
HIDDEN = ("bag", "control", "extension_points", "extensions", "security")

# What the real command has and this one has not: the package that brings it.
ELSEWHERE = {
    "bag": "ros-jazzy-ros2bag",
    "control": "ros-jazzy-ros2controlcli",
    "extension_points": "ros-jazzy-ros2cli",
    "extensions": "ros-jazzy-ros2cli",
    "security": "ros-jazzy-sros2",
}

ALIASES = {"wtf": "doctor"}

VERBS = {
    "action": {
        "info": "Print information about an action",
        "list": "Output a list of action names",
        "send_goal": "Send an action goal",
        "type": "Print a action's type",
    },
    "component": {
        "list": "Output a list of running containers and components",
        "load": "Load a component into a container node",
        "standalone": "Run a component into its own standalone container node",
        "types": "Output a list of components registered in the ament index",
        "unload": "Unload a component from a container node",
    },
    "daemon": {
        "start": "Start the daemon if it isn't running",
        "status": "Output the status of the daemon",
        "stop": "Stop the daemon if it is running",
    },
    "doctor": {
        "hello": "Check network connectivity between multiple hosts",
    },
    "interface": {
        "list": "List all interface types available",
        "package": "Output a list of available interface types within one package",
        "packages": "Output a list of packages that provide interfaces",
        "proto": "Output an interface prototype",
        "show": "Output the interface definition",
    },
    "lifecycle": {
        "get": "Get lifecycle state for one or more nodes",
        "list": "Output a list of available transitions",
        "nodes": "Output a list of nodes with lifecycle",
        "set": "Trigger lifecycle state transition",
    },
    "multicast": {
        "receive": "Receive a single UDP multicast packet",
        "send": "Send a single UDP multicast packet",
    },
    "node": {
        "info": "Output information about a node",
        "list": "Output a list of available nodes",
    },
    "param": {
        "delete": "Delete parameter",
        "describe": "Show descriptive information about declared parameters",
        "dump": "Show all of the parameters of a node in a YAML file format",
        "get": "Get parameter",
        "list": "Output a list of available parameters",
        "load": "Load parameter file for a node",
        "set": "Set parameter",
    },
    "pkg": {
        "create": "Create a new ROS 2 package",
        "executables": "Output a list of package specific executables",
        "list": "Output a list of available packages",
        "prefix": "Output the prefix path of a package",
        "xml": "Output the XML of the package manifest or a specific tag",
    },
    "service": {
        "call": "Call a service",
        "echo": "Echo a service",
        "find": "Output a list of available services of a given type",
        "info": "Print information about a service",
        "list": "Output a list of available services",
        "type": "Output a service's type",
    },
    "topic": {
        "bw": "Display bandwidth used by topic",
        "delay": "Display delay of topic from timestamp in header",
        "echo": "Output messages from a topic",
        "find": "Output a list of available topics of a given type",
        "hz": "Print the average publishing rate to screen",
        "info": "Print information about a topic",
        "list": "Output a list of available topics",
        "pub": "Publish a message to a topic",
        "type": "Print a topic's type",
    },
}
