"""The command line that is really started: one that dies with the launch."""

from __future__ import annotations

import errno
import os
import shutil
from collections.abc import Mapping
from functools import lru_cache


def startable(cmd: list[str], shell: bool, env: Mapping[str, str]) -> list[str]:
    """Through `setpriv` where there is one: the kernel then ends the process when the launch is killed.

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
    return shutil.which("setpriv")


def _require(program: str, env: Mapping[str, str]) -> None:
    if "/" in program and not program.startswith("/"):
        return  # from the process's own working folder
    if shutil.which(program, path=env.get("PATH", os.defpath)) is None:
        there = "/" in program and os.path.lexists(program)
        number = errno.EACCES if there else errno.ENOENT
        raise OSError(number, os.strerror(number), program)
