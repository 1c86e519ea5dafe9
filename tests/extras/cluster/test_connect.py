"""Finding a scheduler, and the error if there is none."""

from __future__ import annotations

import logging
import socket
from pathlib import Path

import pytest

from course.errors import MissingHere, UsageError
from course_cluster import connect

pytest.importorskip("distributed")


def fails(address: str, security: Path | None = None) -> Exception:
    with pytest.raises((MissingHere, UsageError)) as caught, connect.scheduler_at(address, security):
        pass
    return caught.value


@pytest.mark.parametrize(
    "address", ["nonsense", "host:8786", "tcp://host", "http://host:80", "tcp://a b:1", ""]
)
def test_no_address(address: str) -> None:
    assert "tcp://host:8786" in str(getattr(fails(address), "next_step", ""))


@pytest.mark.slow
def test_nobody_there(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(connect, "_CONNECT_TIME", 0.5)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        port = silent.getsockname()[1]
    error = fails(f"tcp://127.0.0.1:{port}")
    assert isinstance(error, MissingHere) and "no Dask scheduler" in error.what


def test_tls_needs_keys() -> None:
    assert "--cluster-security" in str(getattr(fails("tls://127.0.0.1:1"), "next_step", ""))


def test_settings_that_ask_for_tls_are_obeyed(tmp_path: Path) -> None:
    file = tmp_path / "dask.yaml"
    file.write_text("distributed: {comm: {require-encryption: true}}")
    assert "ask for TLS" in str(fails("tcp://127.0.0.1:1", file))


@pytest.mark.parametrize("text", ["[", "a: b", "distributed: 3", "", "!!python/object/apply:os.getcwd []"])
def test_a_file_that_holds_no_settings(tmp_path: Path, text: str) -> None:
    file = tmp_path / "dask.yaml"
    file.write_text(text)
    assert isinstance(fails("tcp://127.0.0.1:1", file), UsageError)


def test_no_such_file(tmp_path: Path) -> None:
    assert isinstance(fails("tcp://127.0.0.1:1", tmp_path / "none.yaml"), UsageError)


def test_keys_that_are_not_there(tmp_path: Path) -> None:
    file = tmp_path / "dask.yaml"
    file.write_text(
        "distributed: {comm: {tls: {ca-file: /none.pem, client: {cert: /none.pem, key: /none.pem}}}}"
    )
    assert "cannot be used" in str(fails("tls://127.0.0.1:1", file))


def test_logs_are_as_before(monkeypatch: pytest.MonkeyPatch) -> None:
    import distributed  # noqa: F401

    log = logging.getLogger("distributed.client")
    monkeypatch.setattr(log, "level", logging.INFO)
    fails("nonsense")
    assert log.level == logging.INFO
