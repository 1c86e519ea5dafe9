"""Grader of chapter 17: a package that defines a message and a service.

It recognizes the types by the hashes that ROS itself announces for them (RIHS01). It reads
the .msg and .srv files only to say what is different.
"""

from __future__ import annotations

from pathlib import Path

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    Recording,
    commands,
    nearest,
    text_places,
)
from lib.interfaces import Section, compare, expect_tag, interface_file

PACKAGE = "package_with_interfaces"
MESSAGE = f"{PACKAGE}/msg/AmazingQuote"
SERVICE = f"{PACKAGE}/srv/WhatIsThePoint"
NEWER = f"{PACKAGE}/srv/AddPoints"  # what the tutorial's Jazzy edition has instead
MESSAGE_HASH = "RIHS01_6eb8a339124c22e6ee8541e6132c3bccee5a2125c643270c85cae174a4aaeb21"
REQUEST_HASH = "RIHS01_e87c30d67764861fc30a04b9d64414ff99bc5be6e31bdc2e5e5e18ea106f8ab4"
RESPONSE_HASH = "RIHS01_c11b8860d83662096ca56a010676029161709fabb468dace3e4f362bd1d2c29c"
ADD_REQUEST_HASH = "RIHS01_87cdf6994b1dbeeb83f054653589a7baf2ec119ad7565f29d36b41f74763869a"
ADD_RESPONSE_HASH = "RIHS01_f46714f3f047386fa6edb3fa5b1414fcc53c6fcf7996a39da4987dffd1783fa0"
QUOTE_FIELDS: Section = (("int32", "id"), ("string", "quote"), ("string", "philosopher_name"))
REQUEST_FIELDS: Section = ((f"{PACKAGE}/AmazingQuote", "quote"),)
RESPONSE_FIELDS: Section = (("geometry_msgs/Point", "point"),)
ADD_REQUEST_FIELDS: Section = (("geometry_msgs/Point", "a"), ("geometry_msgs/Point", "b"))
ADD_RESPONSE_FIELDS: Section = (("geometry_msgs/Point", "result"),)
SERVICES = (
    ("/probe/t1", SERVICE, (REQUEST_HASH, RESPONSE_HASH), (REQUEST_FIELDS, RESPONSE_FIELDS)),
    ("/probe/t2", NEWER, (ADD_REQUEST_HASH, ADD_RESPONSE_HASH), (ADD_REQUEST_FIELDS, ADD_RESPONSE_FIELDS)),
)
PROBE = Path(__file__).with_name("probes") / "ch17_types.py"
PROBES = [name for name, *_ in SERVICES]
EXPORTS = f"share/{PACKAGE}/cmake/ament_cmake_export_dependencies-extras.cmake"
CMAKE = "CMakeLists.txt"

interfaces = Grader("17-interfaces")


@interfaces.scenario
def offer_the_types(arena: Arena) -> None:
    """Use the learner's types in a program of ours. The graph shows their hashes."""
    arena.keep(PACKAGE, EXPORTS)
    probe = arena.companion(PROBE, MESSAGE, SERVICE, NEWER, name="types")
    if arena.until(lambda: arena.printed("ready"), timeout=15, while_running=probe):
        missing = arena.printed("missing ")
        arena.until(lambda: len(hashes_in(arena)) + missing >= 3, timeout=5, while_running=probe)
    arena.interrupt(probe)


def hashes_in(arena: Arena) -> list[str]:
    messages = [endpoint.type_hash for endpoint in arena.ros.graph.publishers("/probe/t0")]
    services = [service.request_hash for service in arena.ros.graph.services if service.name in PROBES]
    return [found for found in (*messages, *services) if found]


@interfaces.check("message", "AmazingQuote is defined as in the task", points=2)
def message(recording: Recording) -> None:
    offered = recording.seen_graph().publishers("/probe/t0")
    if not offered:
        raise Failure(unknown(recording, MESSAGE))
    if offered[0].type_hash == MESSAGE_HASH:
        return
    file = interface_file(recording.sources, PACKAGE, "msg", "AmazingQuote")
    raise Failure(compare(file, (QUOTE_FIELDS,), PACKAGE, "AmazingQuote"))


@interfaces.check("service", "WhatIsThePoint is defined as in the task", points=2, needs="message")
def service(recording: Recording) -> None:
    """Accept AddPoints instead: the tutorial's Jazzy edition has only that."""
    offered = {found.name: found for found in recording.seen_graph().services if found.request_hash}
    wrong = []
    for probe, name, hashes, fields in SERVICES:
        if probe in offered:
            if (offered[probe].request_hash, offered[probe].response_hash) == hashes:
                return
            wrong.append((name.rpartition("/")[2], fields))
    if not wrong:
        raise Failure(unknown(recording, SERVICE))
    short, fields = wrong[0]
    raise Failure(compare(interface_file(recording.sources, PACKAGE, "srv", short), fields, PACKAGE, short))


def called_with(recording: Recording, package: str) -> str | None:
    """The first argument of `rosidl_generate_interfaces`."""
    built = recording.packages.get(package)
    called = commands(recording.sources, built.source, "rosidl_generate_interfaces") if built else ()
    return next((one.words[0] for one in called if one.words), None)


def unknown(recording: Recording, type_name: str) -> Feedback:
    """The package builds without this type, because the file is not listed or has a different name."""
    _, kind, short = type_name.split("/")
    wanted = f"{kind}/{short}.{kind}"
    cmake = next((name for name in recording.sources.names if name.endswith(f"{PACKAGE}/{CMAKE}")), CMAKE)
    called = text_places(recording.sources.below(cmake.rpartition("/")[0]), "rosidl_generate_interfaces(")
    others = [name.rpartition("/")[2] for name in recording.sources.names if name.endswith(f".{kind}")]
    close = nearest(f"{short}.{kind}", [name for name in others if name != f"{short}.{kind}"])
    if not [place for place in called if place.file == cmake]:
        return Feedback(
            summary=f"Nothing generates `{type_name}`: CMakeLists.txt does not call "
            "`rosidl_generate_interfaces`.",
            where=(Location(cmake),),
            advice=f'Call `rosidl_generate_interfaces(${{PROJECT_NAME}} "{wanted}" ...)` before '
            "`ament_package()`.",
        )
    target = called_with(recording, PACKAGE)
    if target and target not in ("${PROJECT_NAME}", PACKAGE):
        return Feedback(
            summary=f"CMakeLists.txt generates interfaces for `{target}`, so ROS can't find `{type_name}`.",
            expected="rosidl_generate_interfaces(${PROJECT_NAME} ...",
            seen=f"rosidl_generate_interfaces({target} ...",
            where=called[:1],
            advice="The first argument of `rosidl_generate_interfaces` must be `${PROJECT_NAME}`.",
        )
    if close:
        return Feedback(
            summary=f"The package has no `{short}`, but it has `{close.rpartition('.')[0]}`.",
            expected=wanted,
            seen=close,
            where=(Location(next(name for name in recording.sources.names if name.endswith(close))),),
            advice=(
                f"Rename the file to `{short}.{kind}`, and change its name in CMakeLists.txt, too. The "
                "file's name becomes the type's name."
            ),
        )
    return Feedback(
        summary=(
            f"The package builds, but without `{type_name}`: `{wanted}` is not listed in CMakeLists.txt."
        ),
        expected=f'"{wanted}" in rosidl_generate_interfaces',
        where=called[:1],
        advice=f'Add the line `"{wanted}"` to `rosidl_generate_interfaces(...)` in CMakeLists.txt.',
    )


@interfaces.check("package_xml", "package.xml declares what interfaces need")
def package_xml(recording: Recording) -> None:
    wanted = (
        (
            ("buildtool_depend", "build_depend", "depend"),
            "rosidl_default_generators",
            "it generates the code",
        ),
        (("exec_depend", "depend"), "rosidl_default_runtime", "programs that use your types need it"),
        (("depend", "build_depend"), "geometry_msgs", "the service uses one of its types"),
        (
            ("member_of_group",),
            "rosidl_interface_packages",
            "it tells ROS that this package defines interfaces",
        ),
    )
    for tags, value, purpose in wanted:
        expect_tag(recording, PACKAGE, tags, value, purpose=purpose)


@interfaces.check("cmake_exports", "CMakeLists.txt exports the runtime")
def cmake_exports(recording: Recording) -> None:
    installed = recording.kept(EXPORTS) or ""
    if "rosidl_default_runtime" in installed:
        return
    places = text_places(recording.sources, "ament_export_dependencies")
    raise Failure(
        Feedback(
            summary="CMakeLists.txt does not export the runtime, `rosidl_default_runtime`.",
            where=places or text_places(recording.sources, "ament_package()"),
            advice=(
                "Add `ament_export_dependencies(rosidl_default_runtime)` before `ament_package()`. "
                "Packages that use your types then find the runtime, too."
            ),
        )
    )
