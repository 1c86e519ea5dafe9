"""The command line that is really started: one that dies with the launch."""

from __future__ import annotations

import errno
import os
import shutil
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path


def startable(cmd: list[str], shell: bool, env: Mapping[str, str]) -> list[str]:
    """Through `setpriv` where there is one: it asks the kernel for that.

    Raises FileNotFoundError or PermissionError for a program that cannot be started.
    """
    if shell:
        cmd = ["/bin/sh", "-c", " ".join(cmd)]
    else:
        _require(cmd[0], env)
    setpriv = _setpriv()
    # It becomes the program: the process's number and its exit code are the program's own.
    return [setpriv, "--pdeathsig", "KILL", "--", *cmd] if setpriv else cmd


@lru_cache(maxsize=1)
def _setpriv() -> str | None:
    found = shutil.which("setpriv")
    # That of busybox is another one, which cannot do it.
    return None if found is None or Path(found).resolve().name == "busybox" else found


def _require(program: str, env: Mapping[str, str]) -> None:
    if "/" in program and not program.startswith("/"):
        return  # from the process's own working folder
    found = shutil.which(program, path=env.get("PATH", os.defpath))
    if found is None:
        there = "/" in program and os.path.lexists(program)
        raise _error(errno.EACCES if there else errno.ENOENT, program)
    if _is_plain_text(found):
        raise _error(errno.ENOEXEC, program)


def _error(number: int, program: str) -> OSError:
    return OSError(number, os.strerror(number), program)


def _is_plain_text(program: str) -> bool:
    """A script without a first line that says of what: setpriv would hand it to a shell."""
    try:
        with Path(program).open("rb") as file:
            head = file.read(128)
    except OSError:
        return False  # it may be run and not read
    return not head.startswith(b"#!") and b"\0" not in head
