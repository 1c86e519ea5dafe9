"""Has a worker call a function of ours, by its name.

Dask sends functions as references that the scheduler and the worker must be able to follow; one that
cannot (another version, no course at all) dies of the message. A name and plain data arrive everywhere.
"""

from __future__ import annotations

import asyncio
import uuid
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from distributed import Client, Future

# What Dask raises when it has waited long enough: two classes before Python 3.11.
TIMED_OUT = (TimeoutError, asyncio.TimeoutError)
_CALL = "__import__('pkgutil').resolve_name(name)(*details)"


def call(
    client: Client, function: Callable[..., object], *details: object, kind: str, **options: Any
) -> Future:
    """details: plain data. kind: what Dask shows of it. options: of Dask's `submit`.

    An ImportError or AttributeError as its outcome says that the worker has no such function.
    """
    return client.submit(
        eval,
        _CALL,
        {"name": f"{function.__module__}:{function.__name__}", "details": details},
        key=f"{kind}-{uuid.uuid4().hex}",
        pure=False,
        **options,
    )
