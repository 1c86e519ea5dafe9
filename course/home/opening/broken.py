"""What the standard library raises for archives that are damaged, or made to confuse it."""

from __future__ import annotations

import contextlib
import lzma
import struct
import tarfile
import zipfile
import zlib
from collections.abc import Iterator

from course.home.opening.finding import Refused

BROKEN = (
    zipfile.BadZipFile,
    tarfile.TarError,
    zlib.error,
    lzma.LZMAError,
    struct.error,
    EOFError,
    NotImplementedError,  # a version or compression of zip that zipfile does not know
    RecursionError,  # headers of headers of headers
    ArithmeticError,
    LookupError,
    ValueError,  # numbers that are none, names that are no text
    TypeError,
)
ADVICE = "Ask for it again; perhaps the upload broke off."


@contextlib.contextmanager
def reading() -> Iterator[None]:
    """Around nothing but calls of the standard library's readers: their errors become Refused.

    An OSError with a number is the machine's (a disk that is full or gone), and passes through.
    """
    try:
        yield
    except BROKEN as error:
        raise Refused("The archive is broken.", ADVICE) from error
    except OSError as error:
        if error.errno is not None:
            raise
        raise Refused("The archive is broken.", ADVICE) from error
