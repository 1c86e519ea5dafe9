"""Guards the real home, and provides fixtures for several rooms."""

from __future__ import annotations

import contextlib
import os
import secrets
import shutil
import signal
import stat
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from course.build import Store
from tests.shared import run_folder

FIXTURES = Path(__file__).parent / "fixtures"
NOBODY = 65534
GUARDED = {
    "HOME": "home",
    "XDG_CONFIG_HOME": "config",
    "XDG_CACHE_HOME": "cache",
    "XDG_DATA_HOME": "data",
    "XDG_STATE_HOME": "state",
    "XDG_RUNTIME_DIR": "runtime",
    "ROS2COURSE_CACHE": "course-cache",
    "ROS2COURSE_HOME": "course-home",  # not made: a test that needs a course home makes one
}


@pytest.hookimpl(tryfirst=True)
def pytest_configure(config: pytest.Config) -> None:
    """Random cases can be drawn again, and signals work.

    Signals work in the programs that tests start, even where pytest itself was told to ignore them: a shell
    script's background jobs ignore SIGINT and SIGQUIT, and what nohup starts ignores SIGHUP.
    """
    if config.option.hypothesis_seed is None:
        config.option.hypothesis_seed = str(secrets.randbelow(10**9))
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for number in (signal.SIGQUIT, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


def pytest_report_header(config: pytest.Config) -> str:
    return f"random cases: --hypothesis-seed={config.option.hypothesis_seed}"


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Print each failure at once, so that a run that hits a time limit has already named it."""
    if report.failed and "PYTEST_XDIST_WORKER" not in os.environ:
        told = f"FAILED {report.nodeid} after {report.duration:.0f} s"
        print(f"\n{told}\n{str(report.longrepr)[-3000:]}", flush=True)


def _guard(monkeypatch: pytest.MonkeyPatch, root: Path) -> None:
    for variable, name in GUARDED.items():
        monkeypatch.setenv(variable, str(root / name))
        if variable != "ROS2COURSE_HOME":
            (root / name).mkdir(mode=0o700)


@pytest.fixture(autouse=True, scope="session")
def _guarded_session(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """For fixtures that live longer than a test, and so start before its own guard."""
    with pytest.MonkeyPatch.context() as monkeypatch:
        _guard(monkeypatch, tmp_path_factory.mktemp("session"))
        monkeypatch.setenv("ROS2COURSE_CACHE", str(run_folder(tmp_path_factory) / "course-cache"))
        yield


@pytest.fixture(scope="session")
def shared_builds(_guarded_session: None) -> Store:
    """Shared by all workers of a run: the same sources are built once."""
    return Store()


@pytest.fixture(autouse=True)
def guarded_home(
    _guarded_session: None, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> Path:
    """Every test has its own home and caches, so anything that it leaves there is harmless."""
    root = tmp_path_factory.mktemp("guard")
    _guard(monkeypatch, root)
    return root / "home"


@pytest.fixture
def small_course(tmp_path: Path) -> Path:
    """A copy of the small course, for a test to break."""
    return shutil.copytree(FIXTURES / "small_course", tmp_path / "small_course", symlinks=True)


@pytest.fixture
def open_folder() -> Iterator[Path]:
    """A folder that any user can reach; pytest's own folders are private."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o755)
        yield folder


@pytest.fixture
def read_only() -> Callable[[Path], contextlib.AbstractContextManager[None]]:
    """`with read_only(folder):` nothing in the folder can be written, not even when root runs the tests.

    The folder must be reachable for others (`open_folder`), and everything imported beforehand.
    """
    return _read_only


@contextlib.contextmanager
def _read_only(folder: Path) -> Iterator[None]:
    modes = {path: stat.S_IMODE(path.stat().st_mode) for path in (folder, *folder.rglob("*"))}
    for path, mode in modes.items():
        path.chmod(mode & ~0o222 | (0o555 if path.is_dir() else 0o444))
    was_root = os.geteuid() == 0
    if was_root:
        os.seteuid(NOBODY)  # permissions do not bind root
    try:
        yield
    finally:
        if was_root:
            os.seteuid(0)
        for path, mode in modes.items():
            path.chmod(mode)
