"""Hostile archives: each is reported, nothing leaves its folder, and nothing incomplete stays."""

from __future__ import annotations

import bz2
import gzip
import io
import lzma
import stat
import struct
import tarfile
import zipfile
import zlib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from course.home.opening import USUAL, Refused, Remark, open_archive
from tests.home.opening.archives import LINK, contents, entry, make_tar, make_zip

SMALL = replace(USUAL, bytes=5_000_000, files=50, file=2_000_000, ratio=50, free=1_000_000)


@pytest.fixture
def room(tmp_path: Path) -> Path:
    """Only `out` may change; a secret is beside it."""
    (tmp_path / "room").mkdir()
    (tmp_path / "secret").write_text("secret")
    return tmp_path / "room"


def opened(archive: Path) -> tuple[dict[str, str], tuple[Remark, ...]]:
    findings = open_archive(archive, archive.parent / "out", SMALL)
    return contents(archive.parent / "out"), findings


def unharmed(room: Path, *there: str) -> bool:
    beside = {path.name for path in room.parent.iterdir()}
    inside = {path.name for path in room.iterdir()}
    return (
        beside == {"room", "secret"}
        and (room.parent / "secret").read_text() == "secret"
        and inside == {*there}
    )


BAD_NAMES = [
    "../evil",
    "a/../../evil",
    "/evil",
    "..\\evil",
    "C:\\evil",
    "c:evil",
    "//host/evil",
    "x" * 256,
    "d/" * 40 + "f",
]


@pytest.mark.parametrize("name", BAD_NAMES)
def test_names_that_lead_out_of_a_zip(room: Path, name: str) -> None:
    found, findings = opened(make_zip(room / "w.zip", {name: "evil", "good": "good"}))
    assert found == {"good": "good"}
    assert len(findings) == 1 and "left out" in findings[0].what
    assert unharmed(room, "w.zip", "out")


@pytest.mark.parametrize("name", [name for name in BAD_NAMES if "\\" not in name])
def test_names_that_lead_out_of_a_tar(room: Path, name: str) -> None:
    found, findings = opened(make_tar(room / "w.tar", entry(name, b"evil"), entry("good", b"good")))
    assert found == {"good": "good"}
    assert len(findings) == 1
    assert unharmed(room, "w.tar", "out")


@pytest.mark.parametrize(
    "target",
    ["../../secret", "/etc/passwd", "..", ".", "missing", "loop", "a/b/../../../../secret", "", "x" * 300],
)
def test_links_out(room: Path, target: str) -> None:
    entries = [entry("loop", kind=tarfile.SYMTYPE, target=target), entry("a/b/f", b"f")]
    found, findings = opened(make_tar(room / "w.tar", *entries))
    if target == ".":  # leads to a folder that contains it: told of when the files are walked
        assert found == {"a/b/f": "f", "loop": "-> ."}
    else:
        assert found == {"a/b/f": "f"}
        assert [finding.where for finding in findings] == ["loop"]


def test_nothing_is_written_through_a_link(room: Path) -> None:
    entries = [
        entry("out", kind=tarfile.SYMTYPE, target="../.."),
        entry("out/secret", b"overwritten"),
        entry("here", kind=tarfile.SYMTYPE, target="sub/deep"),
        entry("there", kind=tarfile.SYMTYPE, target="here/../../.."),
        entry("there/link", kind=tarfile.SYMTYPE, target="x"),
        entry("sub/deep/f", b"f"),
    ]
    found, findings = opened(make_tar(room / "w.tar", *entries))
    assert found == {"out/secret": "overwritten", "here": "-> sub/deep", "sub/deep/f": "f"}
    assert {finding.where for finding in findings} == {"out", "there/link, there"}
    assert unharmed(room, "w.tar", "out")


def test_links_in_a_zip_that_lead_out(room: Path) -> None:
    found, findings = opened(make_zip(room / "w.zip", {"l": "../../secret", "f": "f"}, {"l": LINK}))
    assert found == {"f": "f"}
    assert findings[0].where == "l"


@pytest.mark.parametrize("target", ["../../secret", "/etc/passwd", "missing", "h", "link"])
def test_hard_links_out(room: Path, target: str) -> None:
    link = entry("link", kind=tarfile.SYMTYPE, target="../../secret")
    found, findings = opened(make_tar(room / "w.tar", link, entry("h", kind=tarfile.LNKTYPE, target=target)))
    assert found == {}
    assert all("Links" in finding.what for finding in findings)


@pytest.mark.parametrize("kind", [tarfile.CHRTYPE, tarfile.BLKTYPE, tarfile.FIFOTYPE, b"Z"])
def test_devices_and_pipes(room: Path, kind: bytes) -> None:
    found, findings = opened(make_tar(room / "w.tar", entry("dev", kind=kind), entry("f", b"f")))
    assert found == {"f": "f"}
    assert findings[0].where == "dev"


def test_devices_in_a_zip(room: Path) -> None:
    modes = {"pipe": stat.S_IFIFO | 0o644, "dev": stat.S_IFCHR | 0o644}
    found, findings = opened(make_zip(room / "w.zip", {"pipe": "", "dev": "", "f": "f"}, modes))
    assert found == {"f": "f"}
    assert findings[0].where == "pipe, dev"


def test_names_that_attack_a_terminal(room: Path) -> None:
    names = ["new\nline.py", "esc\x1b[2J.py", "\u202etxt.exe", "\x9b31m.py"]
    found, findings = opened(
        make_tar(room / "w.tar", *(entry(name) for name in names), entry("bad\udcff.py"))
    )
    assert set(found) == {"new_line.py", "esc_[2J.py", "_txt.exe", "_31m.py", "bad_.py"}
    assert findings[0].where == "new\\nline.py, esc\\x1b[2J.py, \\u202etxt.exe and 2 more"


def test_one_name_twice(room: Path) -> None:
    with pytest.warns(UserWarning, match="Duplicate"), zipfile.ZipFile(room / "w.zip", "w") as archive:
        archive.writestr("a", "first")
        archive.writestr("a", "second")
    found, findings = opened(room / "w.zip")
    assert found == {"a": "second"}
    assert "more than one file with this name" in findings[0].what


def test_a_name_for_a_file_and_a_folder(room: Path) -> None:
    found, findings = opened(make_zip(room / "w.zip", {"a": "a", "a/b": "b", "c/d": "d", "c": "c"}))
    assert found == {"a": "a", "c/d": "d"}
    assert findings[0].where == "a/b, c"


def test_an_entry_without_a_name(room: Path) -> None:
    archive = make_zip(room / "w.zip", {"\0a": "a", "f": "f"})
    assert opened(archive)[0] == {"f": "f"}


def test_encrypted(room: Path) -> None:
    archive = make_zip(room / "w.zip", {"a": "a"})
    data = bytearray(archive.read_bytes())
    data[data.find(b"PK\x01\x02") + 8] |= 1
    archive.write_bytes(data)
    refused(room, archive, "encrypted")


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_methods_without_bounds(room: Path, method: int) -> None:
    with zipfile.ZipFile(room / "w.zip", "w", method) as archive:
        archive.writestr("a", "a")
    refused(room, room / "w.zip", "compression method that is not supported")


def refused(room: Path, archive: Path, says: str) -> None:
    with pytest.raises(Refused, match=says):
        open_archive(archive, room / "out", SMALL)
    assert unharmed(room, archive.name)


@pytest.mark.parametrize("compress", [gzip.compress, bz2.compress, lzma.compress])
def test_a_bomb_in_a_tar(room: Path, compress: Callable[[bytes], bytes]) -> None:
    plain = io.BytesIO()
    with tarfile.open(fileobj=plain, mode="w") as archive:
        archive.addfile(entry("zeros", bytes(1_500_000))[0], io.BytesIO(bytes(1_500_000)))
    (room / "w.tgz").write_bytes(compress(plain.getvalue()))
    refused(room, room / "w.tgz", "50 times its archive's size")


def test_a_bomb_that_is_left_out_counts_too(room: Path) -> None:
    archive = make_tar(room / "w.tgz", entry("../zeros", bytes(1_500_000)), entry("f"), mode="w:gz")
    refused(room, archive, "50 times its archive's size")


def test_a_bomb_in_a_zip(room: Path) -> None:
    refused(room, make_zip(room / "w.zip", {"zeros": bytes(1_500_000)}), "50 times its archive's size")


def test_many_small_bombs(room: Path) -> None:
    archive = make_zip(room / "w.zip", {str(n): bytes(100_000) for n in range(30)})
    refused(room, archive, "50 times its archive's size")


def test_sizes_that_lie(room: Path) -> None:
    archive = make_zip(room / "w.zip", {"zeros": bytes(1_500_000)})
    data = bytearray(archive.read_bytes())
    for start, at in ((b"PK\x03\x04", 22), (b"PK\x01\x02", 24)):
        where = data.find(start) + at
        data[where : where + 4] = struct.pack("<I", 10)
    archive.write_bytes(data)
    refused(room, archive, "broken")


def test_one_large_file(room: Path) -> None:
    content = zlib.compress(bytes(1)) * 300_000
    refused(room, make_tar(room / "w.tar", entry("large", content)), "larger than 2 MB")


def test_many_files(room: Path) -> None:
    refused(room, make_zip(room / "w.zip", {f"{n}": "" for n in range(51)}), "more than 50 files")


def test_too_much_in_all(room: Path) -> None:
    content = bytes(range(256)) * 4000
    refused(room, make_tar(room / "w.tar", *(entry(str(n), content) for n in range(6))), "more than 5 MB")


def test_overlapping_entries(room: Path) -> None:
    """Two entries of the list that share one compressed content, as in David Fifield's bomb."""
    archive = make_zip(room / "w.zip", {"a": "a" * 1000, "b": "b"})
    data = bytearray(archive.read_bytes())
    second = data.rfind(b"PK\x01\x02")
    data[second + 42 : second + 46] = struct.pack("<I", 5)
    archive.write_bytes(data)
    refused(room, archive, "overlap")


def test_a_list_of_contents_without_end(room: Path) -> None:
    archive = make_zip(room / "w.zip", {f"{n}": "" for n in range(2000)})
    refused(room, archive, "list of contents")


def test_headers_without_end(room: Path) -> None:
    info, content = entry("a", b"a")
    info.pax_headers = {"comment": "x" * 100_000}
    refused(room, make_tar(room / "w.tar", (info, content)), "broken")


def test_a_header_that_goes_on_and_on(room: Path) -> None:
    """An old GNU sparse file, whose map of holes continues in block after block."""
    header = bytearray(entry("sparse", kind=tarfile.GNUTYPE_SPARSE)[0].tobuf(tarfile.GNU_FORMAT))
    header[482] = 1
    header[148:156] = b" " * 8
    header[148:156] = b"%06o\0 " % sum(header)
    more = bytes(504) + b"\1" + bytes(7)
    (room / "w.tar").write_bytes(bytes(header) + more * 2000 + bytes(512 * 3))
    refused(room, room / "w.tar", "broken")


def test_sparse_files_are_left_out(room: Path) -> None:
    info, content = entry("sparse", b"s")
    info.pax_headers = {"GNU.sparse.map": "0,1", "GNU.sparse.size": "10000000000"}
    found, findings = opened(make_tar(room / "w.tar", (info, content), entry("f", b"f")))
    assert found == {"f": "f"}
    assert findings[0].where == "sparse"


def test_a_header_that_is_wrong_is_not_the_end(room: Path) -> None:
    archive = make_tar(room / "w.tar", entry("a", b"a"), entry("b", b"b"))
    data = bytearray(archive.read_bytes())
    data[1024] = ord("c")
    archive.write_bytes(data)
    refused(room, archive, "broken")


def test_headers_of_headers(room: Path) -> None:
    one = tarfile.TarInfo("././@LongLink")
    one.type, one.size = tarfile.GNUTYPE_LONGNAME, 1
    block = one.tobuf(tarfile.GNU_FORMAT) + b"a".ljust(512, b"\0")
    (room / "w.tar").write_bytes(block * 2000 + bytes(1024))
    refused(room, room / "w.tar", "broken")


@pytest.mark.parametrize("left", [0.2, 0.5, 0.9, 0.97])
@pytest.mark.parametrize("kind", ["zip", "tar", "tar.gz", "tar.bz2", "tar.xz"])
def test_archives_that_broke_off(room: Path, kind: str, left: float) -> None:
    files = [entry(str(n), bytes([n]) * 700) for n in range(9)]
    if kind == "zip":
        archive = make_zip(room / "w.zip", {info.name: content for info, content in files})
    else:
        archive = make_tar(room / f"w.{kind}", *files, mode=f"w:{kind[4:]}")
    whole = archive.read_bytes().rstrip(b"\0")
    archive.write_bytes(whole[: int(len(whole) * left)])
    refused(room, archive, "broken")


@pytest.mark.slow
def test_any_byte_may_be_wrong(room: Path) -> None:
    """Whatever byte is changed: it opens or is refused, harms nothing, and raises no other error."""
    sources = [make_zip(room / "w.zip", {"a/b": "text" * 50, "c": "c"})]
    sources += [
        make_tar(room / "w.tar", entry("a/b", b"text" * 50), entry("c", kind=tarfile.SYMTYPE, target="a"))
    ]
    for archive in sources:
        whole = archive.read_bytes()
        for at in range(0, min(len(whole), 2048), 3):
            archive.write_bytes(whole[:at] + bytes([whole[at] ^ 0xFF]) + whole[at + 1 :])
            try:
                open_archive(archive, room / str(at) / archive.name, SMALL)
            except Refused as error:
                assert error.finding.what
    assert (room.parent / "secret").read_text() == "secret"
    assert {path.name for path in room.parent.iterdir()} == {"room", "secret"}


def test_it_may_not_take_for_ever(room: Path) -> None:
    with pytest.raises(Refused, match="of computing"):
        open_archive(make_zip(room / "w.zip", {"a": "a"}), room / "out", replace(SMALL, seconds=-1.0))
