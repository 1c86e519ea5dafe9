"""Files that a node reads when it starts, and that are gone when the launch has ended."""

from __future__ import annotations

import atexit
import contextlib
import os
from pathlib import Path

_PREFIX = "launch_params_"


def temporary_file(text: str) -> Path:
    import tempfile  # here: it takes long to import, and few launch files come to need it

    with tempfile.NamedTemporaryFile(mode="w", prefix=_PREFIX, delete=False, encoding="utf-8") as file:
        file.write(text)
    atexit.register(_remove, file.name)
    return Path(file.name)


def _remove(path: str) -> None:
    with contextlib.suppress(OSError):
        os.unlink(path)  # noqa: PTH108
