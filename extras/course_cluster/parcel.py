"""What coordinator and worker send each other: text and bytes, up to a limit."""

from __future__ import annotations

import io
import tarfile
from pathlib import Path

from course.home.opening import USUAL, Refused, Remark, open_archive
from course.model import replace

# The most bytes of a packed home, and of a recording, that are sent.
LARGEST_HOME = 64_000_000
LARGEST_EVIDENCE = 128_000_000
_TOO_LARGE = Remark(
    f"It is too large to be sent to a worker: more than {LARGEST_HOME // 1_000_000} MB when packed.",
    "Once the others are done, the same command without --cluster grades what is left on this machine.",
)
# We packed it ourselves, after looking at the files, so any compression ratio is acceptable.
_OWN = replace(USUAL, ratio=1_000_000)


def pack(home: Path) -> bytes:
    """A course home as a compressed tar. Raises Refused if it is too large, and OSError."""
    packed = _Bounded()
    with tarfile.open(fileobj=packed, mode="w:gz", compresslevel=1) as archive:
        for path in sorted(home.rglob("*")):
            archive.add(path, str(path.relative_to(home)), recursive=False)
    return packed.getvalue()


def unpack(packed: bytes, folder: Path) -> Path:
    """Unpack the home to `folder/home`. Raises Refused if this is not a packed home, and StorageError."""
    archive = folder / "home.tar.gz"
    archive.write_bytes(packed)
    open_archive(archive, folder / "home", _OWN)
    archive.unlink()
    return folder / "home"


def evidence_of(recording: Path) -> bytes | None:
    """The recording as bytes; None if there is none, or if it is too large."""
    if not recording.is_file() or recording.stat().st_size > LARGEST_EVIDENCE:
        return None
    return recording.read_bytes()


class _Bounded(io.BytesIO):
    def write(self, data: bytes) -> int:  # type: ignore[override]  # all that gzip writes is bytes
        if self.tell() + len(data) > LARGEST_HOME:
            raise Refused(_TOO_LARGE.what, _TOO_LARGE.advice)
        return super().write(data)
