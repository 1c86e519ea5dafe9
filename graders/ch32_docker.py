"""Graders of chapter 32: a compose file, two nodes in a domain, and a profile without shared memory."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path, PurePosixPath
from typing import Any
from xml.etree import ElementTree

from check_jsonschema.builtin_schemas import get_builtin_schema
from jsonschema import Draft202012Validator, ValidationError
from jsonschema.validators import validator_for

from course.api import (
    Arena,
    Document,
    Failure,
    Feedback,
    Grader,
    Location,
    OurFault,
    Process,
    Recording,
    expect_text,
    listed,
    nearest,
)
from lib.yaml_files import expect_yaml

FOLDER = "docker_tutorial"

# ------------------------------------------------------------------------------------------ 32-compose

COMPOSE = f"{FOLDER}/compose.yml"
SERVICES = ("talker", "listener")
# How Docker reads a signal: with or without SIG, in any case, or as a number.
SIGINT = ("sigint", "int", "2")
DURATION = re.compile(r"(?:(?:\d+\.?\d*|\.\d+)(?:us|µs|ms|s|m|h|d|w))+")
EXTRA = ("additionalProperties", "unevaluatedProperties")

compose = Grader("32-compose", builds=None, ros=False)


@compose.check("reads", f"`~/{COMPOSE}` exists and is YAML")
def reads(recording: Recording) -> None:
    document(recording)


def document(recording: Recording) -> Document:
    advice = "Restore the starter's file with `ros2course reset`. The lesson shows a complete example."
    return expect_yaml(recording, COMPOSE, advice=advice)


@compose.check("valid", "it follows the compose specification", points=2, needs="reads")
def valid(recording: Recording) -> None:
    found = document(recording)
    error = next(iter(sorted(errors(found.data), key=lambda error: len(error.absolute_path))), None)
    if error is not None:
        raise Failure(complaint(found, deepest(error)))


@cache
def specification() -> Mapping[str, Any]:
    return get_builtin_schema("vendor.compose-spec")


def errors(data: Any) -> list[ValidationError]:
    """What violates the specification. A mistake in one place also makes its surroundings invalid."""
    schema = specification()
    every = list(validator_for(schema, default=Draft202012Validator)(schema).iter_errors(data))
    own = [error for error in every if error.validator not in EXTRA]
    return [*(error for error in every if error.validator in EXTRA and unknown(error)), *own]


def deepest(error: ValidationError) -> ValidationError:
    """The innermost mistake, in the form that it belongs to, if several forms are allowed but none fits."""
    while causes := error.context:
        inner = [cause for cause in causes if len(cause.absolute_path) > len(error.absolute_path)]
        inner = inner or [cause for cause in causes if cause.validator in (*EXTRA, "required")]
        if not inner:
            return error
        error = inner[0]
    return error


def unknown(error: ValidationError) -> list[str]:
    """Keys that the specification does not have in this place."""
    known = known_keys(error.schema)
    patterns = error.schema.get("patternProperties", {}) if isinstance(error.schema, Mapping) else {}
    keys = (key for key in error.instance if key not in known and not key.startswith("x-"))
    return [key for key in keys if not any(re.search(pattern, key) for pattern in patterns)]


def known_keys(schema: Any) -> set[str]:
    """The properties of a part of the schema, including those of the parts that it consists of."""
    if not isinstance(schema, Mapping):
        return set()
    parts = [*schema.get("allOf", ())]
    if ref := schema.get("$ref"):
        parts.append(referred(ref))
    return set(schema.get("properties", ())).union(*map(known_keys, parts))


def referred(reference: str) -> Any:
    part: Any = specification()
    for name in reference.removeprefix("#/").split("/"):
        part = part[name]
    return part


def complaint(found: Document, error: ValidationError) -> Feedback:
    place = tuple(error.absolute_path)
    if error.validator in EXTRA and (names := unknown(error)):
        return unknown_key(found, place, names[0], known_keys(error.schema))
    if error.validator == "required":
        name = next(name for name in error.validator_value if name not in error.instance)
        return Feedback(
            summary=f"{key(place)} has no `{name}`.",
            expected=f"{name}:",
            where=(Location(COMPOSE, found.line(place)),),
            advice=f"Add `{name}`, or check whether you misspelled it.",
        )
    if place == ():
        return Feedback(
            summary="The file does not consist of names with a value after each `:`.",
            expected="services: at the start of a line",
            where=(Location(COMPOSE, 1),),
            advice="Put a space after each `:`.",
        )
    return Feedback(
        summary=f"{key(place)} cannot be {short(error.instance)}.",
        expected=wanted(error),
        seen=short(error.instance),
        where=(Location(COMPOSE, found.line(place)),),
        advice=advice_for(error),
    )


def unknown_key(found: Document, place: tuple[Any, ...], name: str, known: Iterable[str]) -> Feedback:
    close = nearest(name, known)
    where = key(place) if place else "a compose file"
    if close:
        advice = f"Write `{close}` if that is what you mean."
    elif not place and name in SERVICES:
        advice = f"Put it below `services:`, with two spaces before `{name}`."
    elif not place and name in known_keys(referred_service()):
        advice = "Put it below a service, indented four spaces."
    elif place == ("services",):
        advice = "Use only letters, digits, `.`, `_`, and `-` in the name of a service."
    else:
        advice = "Remove it, or look up the right name in the lesson's table."
    return Feedback(
        summary=f"`{name}` does not exist in {where}.",
        expected=close,
        seen=name,
        where=(Location(COMPOSE, found.line((*place, name))),),
        advice=advice,
    )


def referred_service() -> Any:
    schema = specification()
    return schema[next(name for name in ("$defs", "definitions") if name in schema)]["service"]


def key(place: tuple[Any, ...]) -> str:
    """`services.talker.stop_signal`, in backquotes."""
    return f"`{'.'.join(map(str, place))}`"


def short(value: Any) -> str:
    """A short description of a value."""
    if value is None:
        return "empty"
    if isinstance(value, bool):
        return "`true` or `false`"
    if isinstance(value, (int, float)):
        return f"the number {value}"[:60]
    if isinstance(value, str):
        return f"the string `{value[:60]}`"
    return "a list" if isinstance(value, list) else "a group of names"


def wanted(error: ValidationError) -> str | None:
    kinds = error.validator_value if error.validator == "type" else None
    names = {"string": "a string", "object": "names, each with a value after its `:`", "array": "a list"}
    names |= {"number": "a number", "integer": "a number", "boolean": "`true` or `false`", "null": "nothing"}
    every = [kinds] if isinstance(kinds, str) else list(kinds or ())
    return " or ".join(dict.fromkeys(names.get(kind, kind) for kind in every)) or None


def advice_for(error: ValidationError) -> str:
    if error.instance is None:
        return "Write its settings below it, and indent each line by two more spaces."
    if str(error.absolute_path[-1]) == "stop_grace_period":
        return "Add the unit: write `10s`, not `10`."
    if error.validator == "type" and error.validator_value == "string":
        return "Put it in quotation marks to make it a string."
    if isinstance(error.instance, list):
        return "Use names here, and remove the `-`. A line that starts with `-` is part of a list."
    return "Compare it with the lesson's example."


@compose.check("services", "it has a service `talker` and a service `listener`", needs="valid")
def services(recording: Recording) -> None:
    found = document(recording)
    there = dict(service_items(found))
    for name in SERVICES:
        if name not in there:
            raise Failure(no_service(found, name, list(there)))
        if "image" not in there[name] and "build" not in there[name]:
            raise Failure(
                Feedback(
                    summary=f"The service `{name}` has neither `image` nor `build`.",
                    where=(place_of(found, name),),
                    advice="Tell Docker what to run, for example with `image: osrf/ros:jazzy-desktop`.",
                )
            )


def service_items(found: Document) -> Iterator[tuple[str, Mapping[str, Any]]]:
    data = found.data.get("services") or {}
    yield from data.items()


def no_service(found: Document, name: str, there: list[str]) -> Feedback:
    close = nearest(name, [other for other in there if other not in SERVICES])
    return Feedback(
        summary=f"There is no service `{name}`{f', but there is `{close}`' if close else ''}.",
        expected=f"{name}:",
        seen=listed(there[:6], "no services"),
        where=(Location(COMPOSE, found.line(("services", *([close] if close else ())))),),
        advice=(
            f"Write `{name}:` below `services:`. Indent the names of all services by the same number "
            "of spaces."
        ),
    )


def place_of(found: Document, *parts: str) -> Location:
    return Location(COMPOSE, found.line(("services", *parts)))


@compose.check("signal", "both are stopped with SIGINT", needs="services")
def signal(recording: Recording) -> None:
    found = document(recording)
    for name in SERVICES:
        value = dict(service_items(found))[name].get("stop_signal")
        if value is None:
            raise Failure(lacks(found, name, "stop_signal", "SIGINT", "So Docker sends SIGTERM."))
        if str(value).lower() not in SIGINT:
            raise Failure(
                Feedback(
                    summary=f"The service `{name}` is stopped with `{str(value)[:40]}`.",
                    expected="SIGINT",
                    seen=str(value)[:40],
                    where=(place_of(found, name, "stop_signal"),),
                    advice="Write SIGINT, the signal that Ctrl+C sends.",
                )
            )


def lacks(found: Document, name: str, what: str, example: str, otherwise: str) -> Feedback:
    service = dict(service_items(found))[name]
    advice = f"Add `{what}: {example}` to it. Each service has its own settings."
    if "extends" in service:
        advice = (
            f"Write `{what}: {example}` in the service itself. The check does not read the service "
            "that it extends."
        )
    return Feedback(
        summary=f"The service `{name}` has no `{what}`. {otherwise}",
        expected=f"{what}: {example}",
        seen=listed(list(service)[:8], "nothing"),
        where=(place_of(found, name),),
        advice=advice,
    )


@compose.check("grace", "both get time to shut down", needs="services")
def grace(recording: Recording) -> None:
    found = document(recording)
    for name in SERVICES:
        value = dict(service_items(found))[name].get("stop_grace_period")
        if value is None:
            otherwise = "So Docker waits only ten seconds."
            raise Failure(lacks(found, name, "stop_grace_period", "20s", otherwise))
        if not lasts(str(value)):
            none = DURATION.fullmatch(str(value))
            raise Failure(
                Feedback(
                    summary=f"The service `{name}` gets no time to shut down."
                    if none
                    else f"The service `{name}` has the time `{str(value)[:40]}`, which is not valid.",
                    expected="a number and its unit, such as 20s or 1m30s",
                    seen=str(value)[:40] or "nothing",
                    where=(place_of(found, name, "stop_grace_period"),),
                    advice="Write a longer time. Otherwise, Docker kills the service immediately."
                    if none
                    else "Write the unit (`ms`, `s`, `m`, or `h`) right after the number, without a space.",
                )
            )


def lasts(text: str) -> bool:
    """Whether this is a duration greater than zero."""
    return bool(DURATION.fullmatch(text)) and bool(re.search(r"[1-9]", text))


# ------------------------------------------------------------------------------------------- 32-domain

DOMAIN_ENV = f"{FOLDER}/domain.env"
VARIABLE = "ROS_DOMAIN_ID"
WANTED = 1
# The highest one that ROS has ports for.
HIGHEST = 232
NODES = ("talker", "listener")
WITNESS = "witness"
ENOUGH = 3
START_TIME = 30.0
# Seconds by which we would have heard nodes that communicate in our domain.
SILENCE = 5.0
PROBES = Path(__file__).parent / "probes"
TALKER, LISTENER = PROBES / "ch32_talker.py", PROBES / "ch32_listener.py"
# The longest value. The system limits the length of variables.
LONGEST = 200
# How ROS reads the variable: it ignores what follows the digits, and a leading 0 makes them octal.
NUMBER = re.compile(r"\s*\+?(0[0-7]*|[1-9]\d{0,8})(?![xX\d])")

domain = Grader("32-domain", builds=None)


@dataclass(frozen=True)
class Setting:
    """One line of a file for `docker run --env-file`. value: None without a `=`."""

    name: str
    value: str | None
    line: int


def settings(text: str) -> tuple[Setting, ...]:
    """The settings as Docker reads them: it keeps quotation marks, and spaces after the name."""
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        line = line.lstrip(" \t")
        if line and not line.startswith("#"):
            name, equals, value = line.partition("=")
            found.append(Setting(name, value if equals else None, number))
    return tuple(found)


def chosen(text: str) -> Setting | None:
    """The last setting of the domain, which is the one that counts."""
    every = [one for one in settings(text) if one.name == VARIABLE and one.value is not None]
    return every[-1] if every else None


def number_of(setting: Setting | None) -> int | None:
    """The domain, or None if the value is not one. Without a setting, it is 0."""
    if setting is None:
        return 0
    read = NUMBER.match(setting.value or "")
    number = int(read[1], 8 if read[1].startswith("0") else 10) if read else HIGHEST + 1
    return number if number <= HIGHEST else None


@domain.scenario
def listen_in_both(arena: Arena) -> None:
    """Start our own nodes with only the domain set. The arena itself listens in domain 0."""
    text = arena.files.text(DOMAIN_ENV)
    if text is None:
        return
    setting = chosen(text)
    number = number_of(setting)
    given = setting.value or "" if number is None and setting else str(arena.domain(number or 0))
    env = {VARIABLE: given.replace("\0", "")[:LONGEST]} if setting else {}
    arena.companion(LISTENER, WITNESS, name=WITNESS, env={VARIABLE: str(arena.domain(WANTED))})
    if not arena.until(lambda: arena.printed(f"{WITNESS} ready"), timeout=START_TIME):
        raise OurFault("the witness in domain 1 did not start")
    listener = arena.companion(LISTENER, "listener", name="listener", env=env)
    talker = arena.companion(TALKER, "hello", name="talker", env=env)
    if not all([is_up(arena, program) for program in (listener, talker)]):  # each of them may end by itself
        return
    arena.until(lambda: arena.printed("listener heard") >= ENOUGH, timeout=START_TIME, while_running=listener)
    arena.until(
        lambda: arena.printed(f"{WITNESS} heard") >= ENOUGH or len(arena.ros.graph.nodes) >= len(NODES),
        timeout=START_TIME if number in (0, WANTED) else SILENCE,
        while_running=listener,
    )


@domain.check("reads", f"`~/{DOMAIN_ENV}` exists and Docker can read it")
def reads_domain(recording: Recording) -> None:
    advice = f"Create it with an editor: `nano ~/{DOMAIN_ENV}`. One line is enough."
    found = expect_text(recording, DOMAIN_ENV, advice=advice)
    every = settings(found.text or "")
    if not every:
        summary = "No line of this file sets a variable."
        raise Failure(Feedback(summary, where=(Location(DOMAIN_ENV),), advice=FORM))
    for setting in every:
        if not setting.name or re.search(r"\s", setting.name):
            raise Failure(bad_name(setting, found.lines[setting.line - 1]))


FORM = "Write each line as `NAME=value`: a name, `=`, and a value."


def bad_name(setting: Setting, line: str) -> Feedback:
    if setting.name.startswith("export "):
        summary = "Docker is not a shell, so `export` becomes part of the variable's name."
        advice = "Remove `export`."
    elif setting.value is not None and setting.name.rstrip() != setting.name:
        summary = "There is a space before the `=`, which becomes part of the variable's name."
        advice = "Write the line without spaces around the `=`."
    else:
        summary, advice = "This line does not set a variable.", FORM
    return Feedback(
        summary=summary,
        expected="NAME=value",
        seen=line.strip()[:80],
        where=(Location(DOMAIN_ENV, setting.line),),
        advice=advice,
    )


@domain.check("starts", "both nodes start with its settings", needs="reads")
def starts(recording: Recording) -> None:
    for name in NODES:
        said = recording.process(name).text
        if f"{name} ready" in said:
            continue
        if recording.process(name).ended_by_itself is None:
            raise OurFault(f"the {name} neither started nor ended")
        setting = chosen(recording.home.file(DOMAIN_ENV).text or "")
        value = (setting.value or "") if setting else ""
        raise Failure(
            Feedback(
                summary=f"A node does not start with {f'`{VARIABLE}={value[:30]}`'}.",
                expected=f"{VARIABLE}={WANTED}",
                seen=f"{VARIABLE}={value[:60]}",
                where=(Location(DOMAIN_ENV, setting.line if setting else None),),
                advice=no_number(value),
                details=tuple(line for line in said if VARIABLE in line or "omain" in line)[-3:],
            )
        )


def no_number(value: str) -> str:
    if value.strip().startswith(("'", '"')):
        return "Remove the quotation marks, which become part of the value."
    if re.fullmatch(r"\s*\d+\s*", value):
        return f"Write `{WANTED}`. Domains range from 0 to {HIGHEST}."
    return f"Write `{WANTED}`. A domain is a number."


@domain.check("hidden", "no node in domain 0 receives their messages", needs="starts")
def hidden(recording: Recording) -> None:
    seen = [name for name in recording.seen_nodes() if name.strip("/") in NODES]
    if not seen:
        return
    found = recording.home.file(DOMAIN_ENV)
    setting, names = chosen(found.text or ""), [one.name for one in settings(found.text or "")]
    others = [name for name in names if name != VARIABLE]
    close = nearest(VARIABLE, others) or next((name for name in others if "DOMAIN" in name.upper()), None)
    if setting is not None and not close:
        summary = f"With `{VARIABLE}={(setting.value or '')[:30]}`, the nodes are in domain 0."
        line: int | None = setting.line
        advice = f"Use domain {WANTED}, as the task says. Domain 0 is the default for every node."
    else:
        line = next((one.line for one in settings(found.text or "") if one.name == close), None)
        summary = f"The file sets `{close}`, which ROS ignores, so the nodes are in domain 0."
        summary = summary if close else f"The file does not set `{VARIABLE}`, so the nodes are in domain 0."
        advice = f"Set the variable with exactly this name: `{VARIABLE}`."
    where = (Location(DOMAIN_ENV, line),)
    raise Failure(Feedback(summary, expected="no node", seen=listed(seen), where=where, advice=advice))


@domain.check(
    "meet",
    f"in domain {WANTED} they find each other, and other nodes receive their messages",
    points=2,
    needs="hidden",
)
def meet(recording: Recording) -> None:
    if any(line.startswith(f"{WITNESS} heard") for line in recording.process(WITNESS).text):
        return
    if not any(line.startswith("listener heard") for line in recording.process("listener").text):
        raise OurFault("two nodes in the same domain did not find each other")
    setting = chosen(recording.home.file(DOMAIN_ENV).text or "")
    if number_of(setting) == WANTED:
        raise OurFault(f"the witness did not hear the talker of its own domain, {WANTED}")
    value = (setting.value or "")[:30] if setting else ""
    raise Failure(
        Feedback(
            summary=f"The two nodes find each other, but in domain {value.strip()}.",
            expected=f"{VARIABLE}={WANTED}",
            seen=f"{VARIABLE}={value}",
            where=(Location(DOMAIN_ENV, setting.line if setting else None),),
            advice=f"Use domain {WANTED}. Nodes can communicate only if they are in the same domain.",
        )
    )


# -------------------------------------------------------------------------------------- 32-udp-profile

PROFILE = "ros2_tutorial_workspace/docker/fastrtps_profile.xml"
MOST_TAGS = 500
SEGMENT = "fastrtps_"
HEARD = "/heard"
# The middleware's message about a profile that it rejects.
REFUSED = re.compile(r"XMLPARSER\s*Error\]\s*(.*?)(?:\s*->|$)")
UNKNOWN_TYPE = re.compile(r"Invalid transport type: '(.*?)'")
NOT_FOUND = re.compile(r"Transport Node not found\. Given ID: (\S+)")

WHITELISTS = ("interfaceWhiteList", "interfaces")
# The names that a profile for this needs.
KNOWN = {
    *("dds", "profiles", "transport_descriptors", "transport_descriptor", "transport_id", "type"),
    *("participant", "rtps", "userTransports", "useBuiltinTransports"),
}
# The name of the talker without a profile.
WITHOUT = "talker without profile"

udp = Grader("32-udp-profile", builds=None)


@udp.scenario
def in_two_containers(arena: Arena) -> None:
    """Give the talker and the listener different /dev/shm, as in two containers.

    A talker without the profile proves that the middleware would use shared memory here.
    """
    if not arena.files.is_file(PROFILE):
        return
    default = {"FASTDDS_BUILTIN_TRANSPORTS": "DEFAULT"}
    control = arena.companion(TALKER, "hello", name=WITHOUT, env=default, own_memory=True)
    is_up(arena, control)
    arena.shared_memory(control)
    control.close()
    heard = arena.ros.subscribe(HEARD, "std_msgs/msg/String")
    env = {**default, "FASTRTPS_DEFAULT_PROFILES_FILE": str(arena.home / PROFILE)}
    listener = arena.companion(LISTENER, "listener", name="listener", env=env, own_memory=True)
    talker = arena.companion(TALKER, "hello", name="talker", env=env, own_memory=True)
    used: list[str] = []
    for program in (listener, talker):
        is_up(arena, program)
        used += segments(arena.shared_memory(program))
    if not used:
        arena.until(lambda: heard.count >= ENOUGH, timeout=25, while_running=talker)


def is_up(arena: Arena, program: Process) -> bool:
    """Wait until the program has created its node or has ended."""

    def told() -> bool:
        return any(line.endswith(" ready") for line in arena.lines(program))

    return arena.until(told, timeout=START_TIME, while_running=program)


def memory(recording: Recording, *names: str) -> list[str]:
    """The middleware's files in these programs' shared memory."""
    looks = [recording.marked(f"shared memory of {name}") for name in names]
    return segments(file for look in looks if look for file in look.detail.split())


def segments(files: Iterable[str]) -> list[str]:
    return [file for file in files if file.startswith(SEGMENT)]


@udp.check("reads", f"`~/{PROFILE}` exists and can be read")
def reads_profile(recording: Recording) -> None:
    profile(recording)


def profile(recording: Recording) -> ElementTree.Element:
    advice = f"Create the folder with `mkdir -p ~/{PurePosixPath(PROFILE).parent}`, then the file in it."
    found = expect_text(recording, PROFILE, advice=advice)
    try:
        root = ElementTree.fromstring(found.text or "")
    except ElementTree.ParseError as error:
        number = min(error.position[0], max(len(found.lines), 1))
        if "declaration not at start" in str(error):
            raise Failure(
                Feedback(
                    summary="Something comes before `<?xml`, which must be the very beginning of the file.",
                    where=(Location(PROFILE, 1),),
                    advice="Move it below that line, or remove it. An empty line or a space counts, too.",
                )
            ) from None
        raise Failure(
            Feedback(
                summary="This file is not valid XML: an element is not closed, here or earlier."
                if found.lines
                else "The file is empty.",
                seen=found.lines[number - 1].strip()[:80] if found.lines else None,
                where=(Location(PROFILE, number),),
                advice="Close each `<name>` with `</name>`, starting with the innermost one.",
                details=(str(error),),
            )
        ) from None
    if sum(1 for _ in root.iter()) > MOST_TAGS:
        raise Failure(
            Feedback(
                summary=f"This file has more than {MOST_TAGS} tags. No profile needs that many.",
                where=(Location(PROFILE),),
                advice="Write only what the task asks for.",
            )
        )
    return root


@udp.check("taken", "ROS accepts it without an error", needs="reads")
def taken(recording: Recording) -> None:
    said = [line for name in NODES for line in recording.process(name).text if "XMLPARSER" in line]
    if not said:
        return
    root = profile(recording)
    lost = next((found[1] for line in said if (found := NOT_FOUND.search(line))), None)
    defined = [text_of(part) for part in named(root, "transport_descriptor", "transport_id")]
    kind = next((found[1] for line in said if (found := UNKNOWN_TYPE.search(line))), None)
    if kind is not None:  # then ROS does not find its transport, either
        raise Failure(
            Feedback(
                summary=f"There is no transport type `{kind[:40]}`.",
                expected="UDPv4",
                seen=kind[:40],
                where=(line_with(recording, f">{kind}<"),),
                advice="Write `<type>UDPv4</type>`, with exactly these uppercase letters.",
            )
        )
    if lost:
        summary = f"There is no transport `{lost[:40]}`."
        advice = "In `userTransports`, use exactly the same name as in the `transport_descriptor`."
        where = line_with(recording, f">{lost}<")
    else:
        strange = next((tag(part) for part in root.iter() if tag(part) not in KNOWN), None)
        summary = f"ROS does not accept this profile: `{strange}` does not belong here."
        summary = summary if strange else "ROS does not accept this profile."
        advice = "Compare the names and the nesting with the lesson's diagram."
        told = " ".join(said)
        if found := re.search(r"<(\w+)> getXMLBool", told):
            strange, advice = found[1], "Its value is `true` or `false`, in lowercase."
        elif found := re.search(r"Found incorrect tag '(\w+)'", told):
            strange, advice = (
                found[1],
                f"Move `{found[1]}` into the element where the lesson's diagram has it.",
            )
        where = line_with(recording, f"<{strange}" if strange else "<participant")
    raise Failure(
        Feedback(
            summary=summary,
            expected=listed(defined) if lost else None,
            seen=lost,
            where=(where,),
            advice=advice,
            details=tuple(dict.fromkeys(REFUSED.sub(r"\1", line).strip()[:150] for line in said))[:4],
        )
    )


def tag(part: ElementTree.Element) -> str:
    """Its name, without the `{...}` that says where the name is defined."""
    return str(part.tag).rpartition("}")[2]


def text_of(part: ElementTree.Element) -> str:
    return (part.text or "").strip()


def named(root: ElementTree.Element, outer: str, inner: str) -> list[ElementTree.Element]:
    """Every `inner` somewhere in an `outer`."""
    return [part for one in root.iter() if tag(one) == outer for part in one.iter() if tag(part) == inner]


def line_with(recording: Recording, text: str) -> Location:
    lines = enumerate(recording.home.file(PROFILE).lines, 1)
    return Location(PROFILE, next((number for number, line in lines if text in line), None))


@udp.check("no-memory", "with it, nodes use no shared memory", points=2, needs="taken")
def no_memory(recording: Recording) -> None:
    if not memory(recording, WITHOUT):
        raise OurFault("a node without a profile uses no shared memory here, so its absence proves nothing")
    used = memory(recording, *NODES)
    if used:
        summary, advice, where = why_shared(recording, profile(recording))
        seen = f"{len(used)} files in /dev/shm"
        raise Failure(Feedback(summary, expected="none", seen=seen, where=(where,), advice=advice))


def why_shared(recording: Recording, root: ElementTree.Element) -> tuple[str, str, Location]:
    """The most likely cause, what to do about it, and where."""
    participants = [part for part in root.iter() if tag(part) == "participant"]
    if not any(part.get("is_default_profile") == "true" for part in participants):
        summary = "The profile is not the default one, so no node uses it."
        advice = 'Start it with `<participant profile_name="..." is_default_profile="true">`.'
        return summary, advice, line_with(recording, "<participant")
    kinds = [text_of(part) for part in named(root, "transport_descriptor", "type")]
    if "SHM" in kinds:
        advice = "Replace `SHM`, which is shared memory, with `UDPv4`, which uses the network."
        return "The profile itself asks for shared memory.", advice, line_with(recording, ">SHM<")
    builtin = named(root, "participant", "useBuiltinTransports")
    if not builtin or text_of(builtin[0]) != "false":
        summary = "The built-in transports stay on, and one of them is shared memory."
        advice = "Turn them off with `<useBuiltinTransports>false</useBuiltinTransports>` in `<rtps>`."
        where = "<useBuiltinTransports" if builtin else "</userTransports"
        return summary, advice, line_with(recording, where)
    advice = "Compare your profile with the lesson's diagram, from the outside in."
    return "The nodes still use shared memory.", advice, line_with(recording, "<participant")


@udp.check("arrive", "messages arrive over UDPv4", points=2, needs="no-memory")
def arrive(recording: Recording) -> None:
    if recording.topic(HEARD).messages:
        return
    root = profile(recording)
    kinds = [text_of(part) for part in named(root, "transport_descriptor", "type")]
    other = next((kind for kind in kinds if kind != "UDPv4"), None)
    addresses = [part for name in WHITELISTS for part in named(root, "transport_descriptor", name)]
    ended = next((name for name in NODES if recording.process(name).ended_by_itself), None)
    if ended:
        summary, where = f"With this profile, the {ended} ends immediately.", "<participant"
        advice = "Remove everything from the profile that the task does not ask for."
    elif other:
        summary, where = f"The transport is `{other}`, so no messages arrive over UDPv4.", f">{other}<"
        advice = "Write `<type>UDPv4</type>`, which all other nodes use."
    elif addresses:
        where = f"<{tag(addresses[0])}"
        summary = "No messages arrive, because the profile allows only some network interfaces."
        advice = "Remove the list of interfaces, or use an address that every computer has."
    else:
        summary, where = "No messages arrive.", "<transport_descriptor"
        advice = "Remove everything from the profile that the task does not ask for."
    raise Failure(
        Feedback(
            summary=summary,
            expected="messages from the talker at the listener",
            seen="none",
            where=(line_with(recording, where),),
            advice=advice,
        )
    )
