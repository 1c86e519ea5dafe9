"""Makes archives as honest programs do, and malicious ones."""

from __future__ import annotations

import io
import stat
import tarfile
import zipfile
from pathlib import Path

LINK = stat.S_IFLNK | 0o777


def make_zip(archive: Path, files: dict[str, str | bytes], modes: dict[str, int] | None = None) -> Path:
    """modes: of a file, with its kind (`LINK`) if it is not a plain file."""
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as out:
        for name, content in files.items():
            info = zipfile.ZipInfo(name)
            info.external_attr = (modes or {}).get(name, stat.S_IFREG | 0o644) << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            out.writestr(info, content)
    return archive


def make_tar(archive: Path, *entries: tuple[tarfile.TarInfo, bytes], mode: str = "w") -> Path:
    with tarfile.open(archive, mode) as out:  # type: ignore[call-overload]
        for info, content in entries:
            out.addfile(info, io.BytesIO(content))
    return archive


def entry(
    name: str, content: bytes = b"", kind: bytes = tarfile.REGTYPE, target: str = "", mode: int = 0o644
) -> tuple[tarfile.TarInfo, bytes]:
    info = tarfile.TarInfo(name)
    info.size, info.type, info.linkname, info.mode = len(content), kind, target, mode
    return info, content


def contents(folder: Path) -> dict[str, str]:
    """Every file below `folder` by its path, with its text; links as `-> target`."""
    found = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.is_symlink():
            found[name] = f"-> {path.readlink()}"
        elif path.is_file():
            found[name] = path.read_text()
    return found
