"""Parts of cases: names, texts, archives, and files that were valid before."""

from __future__ import annotations

import bz2
import contextlib
import gzip
import io
import lzma
import struct
import tarfile
import warnings
import zipfile
from collections.abc import Sequence
from typing import Any

from hypothesis import strategies as st

# Names that lead elsewhere, mean something to a system, a tool or a terminal, or are no text.
NAMES = (
    ".", "..", "../out", "/etc/out", "a/../../out", "//out", "C:\\out", "..\\out", "a\\b", "~", "~root",
    "-rf",
    "--help", "$(touch out)", "`out`", "a;b", "a\nb", "a\0b", "\x1b[2J", "\u202egpj.exe", "\ufeff", " ", "a ",
    "a.",
    "con", "NUL.txt", "é", "e\u0301", "ß", "SS", "ﬀ", "a" * 255, "a" * 300, "é" * 130, "\udcff\udcfe",
    "\ud800",
    "=1+1", "@SUM(1)", "<script>", "{{7*7}}", "%s%n", "[red]", "package.xml", "setup.py", "src", "install",
    ".ros2course", "home.json", "answers", "ros2_tutorial_workspace", "__MACOSX", ".git", "pyvenv.cfg",
    "build",
    "COLCON_IGNORE", "Jane_12_assignsubmission_file_", "doe_LATE_1_2_a.zip", "lab1-jane", "x.zip", "x.tar.gz",
    "x.7z",
)  # fmt: skip
TEXTS = (
    *NAMES,
    "", "\x1b]8;;http://evil/\x07x", "\x1b]52;c;ZXZpbA==\x07", "\x9b31m", "\r\n", "\u2028", "\u2066",
    "$ ", "\r  Passed: 12 of 12 points.\r", "12 passed in 0.01s", "learner@robot:~$ ", "(venv) $ ",
    "Traceback (most recent call last):", "KeyboardInterrupt", "  ^^^^", "Killed",
    "Segmentation fault (core dumped)",
    '  File "/usr/lib/python3/dist-packages/rclpy/executors.py", line 99999999999999999999, in spin',
    '  File "setup.py", line 0, in <module>', '  File "<string>", line -1', "    raise", "SyntaxError:",
    "rclpy._rclpy_pybind11.RCLError: failed to create node", "ModuleNotFoundError: No module named ''",
    "[ERROR] [1.0e999] [a.b]: x", "[INFO] [-1] []: ", "[INFO] [launch]: process[",
    "==1==ERROR: AddressSanitizer: ",
    "    #0 0x0 in main /x.cpp:0", "runtime error: ", "terminate called after throwing an instance of 'x'",
    "OSError: [Errno 28] No space left on device", "CMake Error at CMakeLists.txt:99999999999 (x):",
    "a.py:1:1: error: ",
    "colcon build: error: ", "error: package directory 'x' does not exist",
    "ImportError: cannot import name 'x' from",
    "9" * 4400, "(" * 300, "[" * 3000, "x" * 5000, "١٢٣", "1e999", "NaN", "null", "0x", "\\N{", "%(x)s",
    "${x}",
)  # fmt: skip
_NUMBERS = (0, 1, 0x7F, 0xFF, 0xFFFF, 0x7FFFFFFF, 0xFFFFFFFF)


def _some(known: Sequence[str], between: str) -> st.SearchStrategy[str]:
    several = st.lists(st.sampled_from(known), max_size=6).map(between.join)
    return st.one_of(st.sampled_from(known), st.text(max_size=100), several)


names = _some(NAMES, "/")
texts = _some(TEXTS, "\n")
json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.integers(-(10**400), 10**400) | texts,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(texts, inner, max_size=4),
    max_leaves=8,
)


@st.composite
def mangled(draw: Any, samples: Sequence[bytes]) -> bytes:
    """One of the samples, or nothing, with parts of it changed, doubled, moved, removed, or inserted."""
    data = bytearray(draw(st.sampled_from([*samples, b""])))
    for _ in range(draw(st.integers(1, 6))):
        at, end = sorted((draw(st.integers(0, len(data))), draw(st.integers(0, len(data)))))
        match draw(st.integers(0, 5)):
            case 0:
                data[at:at] = draw(st.binary(max_size=40))
            case 1:
                del data[at : min(end, at + 200)]
            case 2:
                data[at:at] = data[at : min(end, at + 2000)] * draw(st.sampled_from((1, 2, 50)))
            case 3:
                data[at : at + 4] = struct.pack("<I", draw(st.sampled_from(_NUMBERS)))
            case 4:
                data[at:at] = draw(texts).encode("utf-8", "surrogatepass")
            case _:
                data[at : at + 1] = bytes([draw(st.integers(0, 255))])
    return bytes(data)


_MODES = st.sampled_from((0o100644, 0o120777, 0o040755, 0o010644, 0o104755, 0))
_COMPRESSIONS = st.sampled_from((zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED))
_CONTENTS = texts.map(lambda text: text.encode("utf-8", "replace")) | st.just(bytes(3_000_000))
_TAR_KINDS = st.sampled_from((b"0", b"1", b"2", b"3", b"4", b"5", b"6", b"7", b"L", b"S", b"x", b"Z"))


@st.composite
def zips(draw: Any) -> bytes:
    """With odd names, links, duplicates, kinds, encryption, and false sizes and offsets."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as out, warnings.catch_warnings():
        warnings.simplefilter("ignore")  # names may be there twice
        for name in draw(st.lists(names, max_size=8)):
            info = zipfile.ZipInfo("x")
            info.filename = name.encode("utf-8", "replace").decode()
            info.external_attr = (
                draw(st.sampled_from((0o100644, 0o120777, 0o040755, 0o010644, 0o104755, 0))) << 16
            )
            info.compress_type = draw(
                st.sampled_from((zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED, zipfile.ZIP_LZMA))
            )
            content = draw(
                st.one_of(texts.map(lambda text: text.encode("utf-8", "replace")), st.just(bytes(3_000_000)))
            )
            out.writestr(info, content)
    return draw(st.one_of(st.just(buffer.getvalue()), mangled([buffer.getvalue()])))


@st.composite
def tars(draw: Any) -> bytes:
    """With odd names, links in all directions, devices, and false headers; with any compression."""
    buffer = io.BytesIO()
    form = draw(st.sampled_from((tarfile.PAX_FORMAT, tarfile.GNU_FORMAT, tarfile.USTAR_FORMAT)))
    with tarfile.open(fileobj=buffer, mode="w:", format=form, errors="surrogatepass") as out:
        for name in draw(st.lists(names, max_size=8)):
            info = tarfile.TarInfo(name.replace("\0", ""))
            info.type = draw(
                st.sampled_from((b"0", b"1", b"2", b"3", b"4", b"5", b"6", b"7", b"L", b"S", b"x", b"Z"))
            )
            info.linkname = draw(names).replace("\0", "")
            info.mode, info.uid = draw(st.sampled_from(((0o644, 0), (0o7777, 0), (0, 2_000_000))))
            content = draw(texts).encode("utf-8", "replace") if info.isreg() else b""
            info.size = draw(st.sampled_from((len(content), len(content), 0, 10**12)))
            with contextlib.suppress(ValueError):  # a name that this format has no place for
                out.addfile(info, io.BytesIO(content + bytes(1024)) if info.size < 10**6 else None)
    packed = draw(st.sampled_from((bytes, gzip.compress, bz2.compress, _xz)))(buffer.getvalue())
    return draw(st.one_of(st.just(packed), mangled([packed])))


def _xz(data: bytes) -> bytes:
    return lzma.compress(data, preset=0)  # with the usual preset, each call takes 100 MB
