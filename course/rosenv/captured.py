"""What sourcing an installed ROS's setup.bash does to an environment: asked of a bash, then remembered."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from course.errors import MissingHere
from course.rosenv.files import write_atomic
from course.rosenv.identity import digest
from course.rosenv.model import Ros
from course.rosenv.paths import cache_dir
from course.rosenv.setup_files import setup_script
from course.rosenv.variables import LISTS

_PLAIN_PATH = "/usr/local/bin:/usr/bin:/bin"
_PATIENCE = 60  # seconds; sourcing takes well under one, on a cold and busy disk a few


def captured_variables(ros: Ros, environ: Mapping[str, str]) -> dict[str, str]:
    """The variables of paths that setup.bash sets; PATH holds only what it adds."""
    remembered = cache_dir(environ) / "rosenv" / f"{digest([str(ros.prefix)])}.json"
    if (variables := _recall(remembered, ros)) is not None:
        return variables
    variables = _source(setup_script(ros), environ)
    # Not being able to remember costs a moment the next time, no more.
    with suppress(OSError):
        write_atomic(remembered, json.dumps({"identity": ros.identity, "variables": variables}))
    return variables


def _recall(file: Path, ros: Ros) -> dict[str, str] | None:
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
        if content["identity"] == ros.identity:
            return {str(name): str(value) for name, value in content["variables"].items()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        pass  # never made, or damaged: made anew
    return None


def _source(script: Path, environ: Mapping[str, str]) -> dict[str, str]:
    base = {"PATH": _PLAIN_PATH, "HOME": environ.get("HOME", "/")}
    command = ["bash", "--noprofile", "--norc", "-c", '. "$1" >&2; exec env -0', "bash", str(script)]
    try:
        done = subprocess.run(
            command, env=base, stdin=subprocess.DEVNULL, capture_output=True, timeout=_PATIENCE
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise _unusable(script, str(error)) from error
    variables = _added(done.stdout)
    if "AMENT_PREFIX_PATH" not in variables:
        said = done.stderr.decode(errors="replace").strip().splitlines()
        raise _unusable(script, said[-1] if said else "it sets no AMENT_PREFIX_PATH")
    return variables


def _added(output: bytes) -> dict[str, str]:
    pairs = (os.fsdecode(entry).partition("=") for entry in output.split(b"\0") if entry)
    found = {name: value for name, _, value in pairs if name in LISTS}
    plain = _PLAIN_PATH.split(":")
    found["PATH"] = ":".join(path for path in found.get("PATH", "").split(":") if path not in plain)
    return found


def _unusable(script: Path, reason: str) -> MissingHere:
    return MissingHere(
        f"The ROS 2 installed here cannot be used: {script}: {reason}.",
        f"See what this says, then repair or reinstall that ROS: bash -c 'source {script}'",
    )
