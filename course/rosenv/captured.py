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

_PLAIN_PATH = "/usr/local/bin:/usr/bin:/bin"
_BY_THE_SHELL = frozenset({"_", "SHLVL", "PWD", "OLDPWD", "HOME"})
_PATIENCE = 60  # seconds; sourcing takes well under one, on a cold and busy disk a few


def captured_variables(ros: Ros, environ: Mapping[str, str]) -> dict[str, str]:
    """The variables that setup.bash sets; PATH holds only what it adds."""
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
    command = ["bash", "--noprofile", "--norc", "-c", '. "$1" >&2 && exec env -0', "bash", str(script)]
    try:
        done = subprocess.run(
            command, env=base, stdin=subprocess.DEVNULL, capture_output=True, timeout=_PATIENCE, check=True
        )
    except (OSError, subprocess.SubprocessError) as error:
        what = f"{script} could not be sourced: {_reason(error)}."
        raise MissingHere(what, f"See what this says: bash -c 'source {script}'") from error
    return _added(done.stdout)


def _added(output: bytes) -> dict[str, str]:
    pairs = (os.fsdecode(entry).partition("=") for entry in output.split(b"\0") if entry)
    found = {name: value for name, _, value in pairs if name not in _BY_THE_SHELL}
    plain = _PLAIN_PATH.split(":")
    found["PATH"] = ":".join(path for path in found.get("PATH", "").split(":") if path not in plain)
    return found


def _reason(error: Exception) -> str:
    if isinstance(error, subprocess.CalledProcessError):
        lines = error.stderr.decode(errors="replace").strip().splitlines()
        return lines[-1] if lines else f"it ended with {error.returncode}"
    if isinstance(error, subprocess.TimeoutExpired):
        return f"it did not end within {_PATIENCE} seconds"
    return str(error)
