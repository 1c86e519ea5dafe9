"""Connects to a Dask scheduler: one that is already running, or our own on this machine."""

from __future__ import annotations

import contextlib
import logging
import re
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import Any

import dask
import yaml
from distributed import Client, LocalCluster
from distributed.security import Security

from course.batch.run import default_jobs
from course.cli.usage import installing
from course.errors import MissingHere, UsageError
from course_cluster.coordinator import TIMED_OUT

# Instead of a scheduler's address: a cluster on this machine.
LOCAL = "local"
_CONNECT_TIME = 10.0
_ADDRESS = re.compile(r"(tcp|tls|ws|wss)://[^/\s]+:\d+")
_SETTINGS_ARE = "docs/cluster.md shows them."
_LOGS = ("distributed", "distributed.client", "tornado.application")
# Dask would warn about each large submission; its log belongs on its own terminals.
_SETTINGS = {"distributed.admin.large-graph-warning-threshold": "1 GB"}


@contextlib.contextmanager
def scheduler_at(address: str, security: Path | None = None) -> Iterator[Client]:
    """A connection to the scheduler at `address`, or to our own workers for `local`.

    security: a YAML file with Dask's configuration, for the keys of TLS.
    Raises UsageError for an invalid address or file, and MissingHere if nobody answers.
    """
    with _quiet(), dask.config.set(_SETTINGS), dask.config.set(_configuration(security)):
        if address == LOCAL:
            with _workers_here() as client:
                yield client
        else:
            with contextlib.closing(_client(address)) as client:
                yield client


def _client(address: str) -> Client:
    if not _ADDRESS.fullmatch(address):
        raise UsageError(
            f"`{address}` is not the address of a scheduler.", f"For example `tcp://host:8786`, or `{LOCAL}`."
        )
    _require_keys(address)
    try:
        return Client(address, timeout=_CONNECT_TIME, set_as_default=False)
    except (OSError, *TIMED_OUT) as error:
        raise MissingHere(
            f"There is no Dask scheduler at {address}: {error}",
            "`dask scheduler` on that machine starts one and prints its address; see docs/cluster.md.",
        ) from error


def _require_keys(address: str) -> None:
    """Dask itself would fail later, with a worse message."""
    try:
        keys = Security().get_connection_args("client")
    except (OSError, ValueError) as error:
        raise UsageError(f"Dask's settings for TLS cannot be used: {error}.", _SETTINGS_ARE) from error
    if address.startswith(("tls:", "wss:")) and not keys.get("ssl_context"):
        raise UsageError(
            f"{address} needs keys for TLS.", f"Give them with --cluster-security. {_SETTINGS_ARE}"
        )
    if address.startswith(("tcp:", "ws:")) and keys.get("require_encryption"):
        raise UsageError(
            f"Dask's settings ask for TLS, which {address} does not use.", "Start it with `tls://`."
        )


@contextlib.contextmanager
def _workers_here() -> Generator[Client, None, None]:
    """Workers that end with us. Temporary keys keep all other users of this machine out."""
    workers = max(1, default_jobs() // 2)
    with (
        LocalCluster(
            n_workers=workers,
            threads_per_worker=default_jobs() // workers,
            dashboard_address=None,
            security=_own_keys(),
            silence_logs=logging.CRITICAL,
            memory_limit=None,
        ) as cluster,
        Client(cluster, set_as_default=False) as client,
    ):
        yield client


def _own_keys() -> Security:
    try:
        return Security.temporary()
    except ImportError as error:
        raise MissingHere(
            f"--cluster {LOCAL} needs a package that is not installed: {error}.",
            f"`{installing('cluster')}` installs it.",
        ) from error


def _configuration(file: Path | None) -> dict[str, Any]:
    """Dask's configuration, overridden by that of `file`."""
    if file is None:
        return {}
    try:
        read = yaml.safe_load(file.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise UsageError(f"{file} cannot be read: {error}", "Name a YAML file with Dask settings.") from error
    if not isinstance(read, dict) or not isinstance(read.get("distributed"), dict):
        raise UsageError(f"{file} has no `distributed:` settings.", "docs/cluster.md shows such a file.")
    merged: dict[str, Any] = dask.config.merge(dask.config.config, read)
    return merged


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Silence Dask: we report errors ourselves, once."""
    levels = {name: logging.getLogger(name).level for name in _LOGS}
    try:
        for name in levels:
            logging.getLogger(name).setLevel(logging.CRITICAL)
        yield
    finally:
        for name, level in levels.items():
            logging.getLogger(name).setLevel(level)
