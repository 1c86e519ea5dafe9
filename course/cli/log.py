"""Writes the details of our own errors to a log, for the people who fix them."""

from __future__ import annotations

import os
import platform
import time
import traceback
from collections.abc import Sequence
from pathlib import Path

from course import __version__
from course.files import cache_dir


def write_log(kind: str, error: Exception, words: Sequence[str]) -> Path | None:
    """A new file in the cache's `logs` folder with the traceback; None where it cannot be written."""
    head = f"ros2course {__version__}, Python {platform.python_version()}, {platform.platform()}"
    command = " ".join(words)
    return save_log(kind, f"{head}\ncommand: {command}\n\n{''.join(traceback.format_exception(error))}")


def save_log(kind: str, text: str) -> Path | None:
    """Write `text` to a new dated file among the logs; None where it cannot be written."""
    stamp = time.strftime("%Y-%m-%dT%H-%M-%S")
    file = cache_dir(os.environ) / "logs" / f"{kind}-{stamp}-{os.getpid()}.log"
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8", errors="backslashreplace")
    except OSError:
        return None
    return file
