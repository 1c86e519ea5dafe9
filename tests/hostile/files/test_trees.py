"""Trees that would keep a walker busy, or lead it astray; nothing runs."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.build import Workspace
from course.build.builder import Unbuildable, build_order
from course.build.package_sources import TooMuch, source_files
from course.evidence.home_files import read_entries
from course.evidence.sources import read_sources
from course.explain.package_xml import Manifest, ManifestFault, read_manifest, strict_fault
from tests.build.packages import make_package

SRC = "ros2_tutorial_workspace/src"


@pytest.fixture
def home(tmp_path: Path) -> Iterator[Path]:
    folder = tmp_path / "home"
    make_package(folder / SRC, "strange")
    yield folder
    subprocess.run(["rm", "-rf", folder], check=True)  # pytest's own cleanup cannot handle it


def scan(home: Path) -> Workspace:
    return Workspace.scan(home / "ros2_tutorial_workspace", home)


def dig(top: Path, depth: int) -> None:
    here = os.open(top, os.O_RDONLY)
    for _ in range(depth):
        os.mkdir("d", dir_fd=here)
        below = os.open("d", os.O_RDONLY, dir_fd=here)
        os.close(here)
        here = below
    os.close(here)


def test_folders_a_thousand_deep(home: Path) -> None:
    for top in (home / SRC, home / SRC / "strange"):
        dig(top, 1100)
    assert [package.name for package in scan(home).packages] == ["strange"]
    with pytest.raises(TooMuch) as caught:
        source_files(home / SRC / "strange", home)
    assert caught.value.largest == "d"
    assert read_sources(home, [SRC, "."]).names
    assert read_entries(home, [SRC, "*/*/d"])


@pytest.mark.slow
def test_links_from_each_folder_to_all_others(home: Path) -> None:
    """Followed blindly, there are more paths through them than anyone can follow."""
    for top in (home / SRC / "web", home / SRC / "strange" / "web"):
        for name in range(12):
            (top / str(name)).mkdir(parents=True)
        for folder in list(top.iterdir()):
            for other in range(12):
                (folder / f"to-{other}").symlink_to(f"../{other}")
    assert [package.name for package in scan(home).packages] == ["strange"]
    with pytest.raises(TooMuch) as caught:
        source_files(home / SRC / "strange", home)
    assert caught.value.largest == "web"
    assert read_sources(home, [SRC]).names
    read_entries(home, [SRC])


def test_links_out_of_the_workspace(home: Path, tmp_path: Path) -> None:
    make_package(tmp_path / "outside", "solution")
    for name, target in (
        ("a", tmp_path / "outside"),
        ("b", "/"),
        ("c", "/proc"),
        ("d", "/usr"),
        ("e", "../../../.."),
    ):
        (home / SRC / name).symlink_to(target)
    make_package(home / "elsewhere", "inside")
    (home / SRC / "f").symlink_to("../../elsewhere")
    assert [package.name for package in scan(home).packages] == ["inside", "strange"]


def test_links_are_followed_in_a_home_that_is_trusted(home: Path, tmp_path: Path) -> None:
    make_package(tmp_path / "repository", "mine")
    (home / SRC / "mine").symlink_to(tmp_path / "repository/mine")
    names = [
        package.name
        for package in Workspace.scan(home / "ros2_tutorial_workspace", home, trusted=True).packages
    ]
    assert names == ["mine", "strange"]
    assert [package.name for package in scan(home).packages] == ["strange"]
    with pytest.raises(Unbuildable) as caught:
        build_order(scan(home), ["mine"])
    told = caught.value.failure.feedback
    assert told.advice == f"{SRC}/mine is a link out of the course home: replace it with the folder."


@pytest.mark.parametrize("kind", ["pipe", "zero", "environ", "folder", "loop", "huge"])
def test_a_package_xml_that_is_none(home: Path, kind: str) -> None:
    file = home / SRC / "strange/package.xml"
    file.unlink()
    if kind == "pipe":
        os.mkfifo(file)
    elif kind == "folder":
        file.mkdir()
    elif kind == "huge":
        with file.open("wb") as opened:
            opened.truncate(200_000_000)
    else:
        targets = {"zero": "/dev/zero", "environ": "/proc/self/environ", "loop": "package.xml"}
        file.symlink_to(targets[kind])
    with pytest.raises(Unbuildable) as caught:
        build_order(scan(home), ["strange"])
    words = {
        "folder": "There is no package",
        "huge": "it has more than 256 KiB",
        "pipe": "it is not a plain file",
    }
    told = caught.value.failure.feedback
    assert words.get(kind, "it is a link to a place outside the course home, or to nothing") in told.summary
    assert not told.details


LAUGHS = "".join(f'<!ENTITY l{n} "{f"&l{n - 1};" * 10}">' for n in range(1, 10))
BOMBS = {
    "billion laughs": f'<!DOCTYPE p [<!ENTITY l0 "ha">{LAUGHS}]><package><name>&l9;</name></package>',
    "file": '<!DOCTYPE p [<!ENTITY f SYSTEM "file:///etc/passwd">]><package><name>&f;</name></package>',
    "parameter": '<!DOCTYPE p [<!ENTITY % f SYSTEM "file:///etc/passwd"> %f;]><package/>',
    "deep": "<package>" + "<a>" * 20_000 + "</a>" * 20_000 + "</package>",
    "open": "<package>" + "<a>" * 40_000,
    "attributes": "<package " + " ".join(f'a{n}="{n}"' for n in range(20_000)) + "/>",
    "same attribute": "<package" + ' a="1"' * 20_000 + "/>",
    "names": "<package>" + "<name>strange</name>" * 10_000 + "</package>",
    "comments": "<package>" + "<!-- -->" * 30_000 + "</package>",
    "yaml": "a: &a [x]\nb: &b [*a, *a, *a]\n!!python/object/apply:os.system ['true']\n",
    "no text": "\x00\x01\x02",
    "empty": "",
}


@pytest.mark.slow
@pytest.mark.parametrize("name", list(BOMBS))
def test_bombs_are_refused(home: Path, name: str) -> None:
    found = read_manifest(BOMBS[name].encode())
    assert isinstance(found, ManifestFault)
    assert len(found.what) < 200
    assert "root:" not in found.what
    (home / SRC / "strange/package.xml").write_text(BOMBS[name])
    with pytest.raises(Unbuildable):
        build_order(scan(home), ["strange"])


@pytest.mark.parametrize("encoding", ["utf-16", "utf-32", "utf-7", "latin-1", "cp037"])
def test_other_encodings_are_read_or_refused(home: Path, encoding: str) -> None:
    file = home / SRC / "strange/package.xml"
    text = f'<?xml version="1.0" encoding="{encoding}"?>\n{file.read_text()}'
    assert isinstance(read_manifest(text.encode(encoding)), ManifestFault | Manifest)


@pytest.mark.parametrize(
    "condition",
    [
        "(" * 5000 + "$A == 1" + ")" * 5000,
        "$A == 1 and " * 5000 + "$A == 1",
        "(" * 30 + "$A" + ")" * 29,
        "$" * 200,
    ],
    ids=["brackets", "long", "unclosed", "names"],
)
def test_conditions_that_take_for_ever(home: Path, condition: str) -> None:
    file = home / SRC / "strange/package.xml"
    tag = f'<depend condition="{condition}">rclpy</depend></package>'
    file.write_text(file.read_text().replace("</package>", tag))
    assert [package.name for package in scan(home).packages] == ["strange"]
    strict_fault(file)
