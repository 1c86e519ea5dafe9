"""A server for the page, only for browsers on this machine.

It answers only GET and HEAD, only under an address that cannot be guessed, and only if the request names this
machine as its host: a foreign name that leads here (DNS rebinding) gets nothing.
"""

from __future__ import annotations

import re
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, Protocol
from urllib.parse import urlsplit

from course.errors import CourseError, UsageError
from course.report.page.html import policy

HERE = "127.0.0.1"
_SUBMISSION = re.compile(r"submission/(\d{1,6})\.json", re.ASCII)
_HTML, _JSON = "text/html; charset=utf-8", "application/json; charset=utf-8"
_QUIET_SECONDS = 10.0


class PageSource(Protocol):
    """What is shown. Its methods may be called from many threads at once."""

    def page(self) -> str: ...

    def tag(self) -> str: ...

    def news(self) -> tuple[str, str]: ...

    def submission(self, place: int) -> str | None: ...


class PageServer(ThreadingHTTPServer):
    """address: what to open in a browser."""

    daemon_threads = True  # open connections must not delay Ctrl+C
    block_on_close = False

    def __init__(self, source: PageSource, port: int) -> None:
        super().__init__((HERE, port), _Handler)
        self.source = source
        self.hosts = {f"{HERE}:{self.server_port}", f"localhost:{self.server_port}"}
        self.root = f"/{secrets.token_urlsafe(12)}/"
        self.address = f"http://{HERE}:{self.server_port}{self.root}"

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Ignore it: browsers hang up all the time, and errors in the results were sent as an answer."""


@contextmanager
def serving(source: PageSource, port: int) -> Iterator[PageServer]:
    """A server on this port, or on a free one for 0; the caller starts it. Raises UsageError."""
    try:
        server = PageServer(source, port)
    except OSError as error:
        step = "Name another --port, or leave it out."
        raise UsageError(f"Port {port} cannot be used: {error.strerror}.", step) from error
    with server:
        yield server


class _Handler(BaseHTTPRequestHandler):
    server: PageServer
    timeout = _QUIET_SECONDS

    def do_GET(self) -> None:
        try:
            self._answer()
        except CourseError as error:
            self._send(HTTPStatus.SERVICE_UNAVAILABLE, error.what)

    do_HEAD = do_GET  # noqa: N815

    def _refuse(self) -> None:
        self._send(HTTPStatus.METHOD_NOT_ALLOWED, "This page is read-only.", {"Allow": "GET, HEAD"})

    do_POST = do_PUT = do_DELETE = do_PATCH = do_OPTIONS = do_TRACE = do_CONNECT = _refuse  # noqa: N815

    def _answer(self) -> None:
        if self.headers.get_all("Host", []) not in [[host] for host in self.server.hosts]:
            self._send(HTTPStatus.MISDIRECTED_REQUEST, f"Open {HERE}, by this number.")
            return
        path = urlsplit(self.path).path
        inside = path.removeprefix(self.server.root)
        found = _SUBMISSION.fullmatch(inside)
        if path == self.server.root:
            self._send(HTTPStatus.OK, self.server.source.page(), kind=_HTML)
        elif path == f"{self.server.root}data.json":
            self._send_news()
        elif found and inside != path:
            self._send_submission(int(found[1]))
        else:
            self._send(HTTPStatus.NOT_FOUND, "There is nothing here: open the full address.")

    def _send_news(self) -> None:
        if self.headers.get("If-None-Match") == f'"{self.server.source.tag()}"':
            self._send(HTTPStatus.NOT_MODIFIED, "")
            return
        tag, text = self.server.source.news()
        self._send(HTTPStatus.OK, text, {"ETag": f'"{tag}"'}, _JSON)

    def _send_submission(self, place: int) -> None:
        text = self.server.source.submission(place)
        if text is None:
            self._send(HTTPStatus.NOT_FOUND, "The class has nobody at this position.")
        else:
            self._send(HTTPStatus.OK, text, kind=_JSON)

    def _send(
        self, status: HTTPStatus, text: str, headers: dict[str, str] | None = None, kind: str = "text/plain"
    ) -> None:
        body = text.encode()
        self.send_response(status)
        if status is not HTTPStatus.NOT_MODIFIED:
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(body)))
        for name, value in {**_GUARDS, "Content-Security-Policy": _policy(), **(headers or {})}.items():
            self.send_header(name, value)
        self.end_headers()
        if self.command != "HEAD" and status is not HTTPStatus.NOT_MODIFIED:
            self.wfile.write(body)

    def version_string(self) -> str:
        return "ros2course"

    def log_message(self, format: str, *args: Any) -> None:
        """Do not print requests."""


_GUARDS = {
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cache-Control": "no-store",
}


def _policy() -> str:
    return f"{policy('live')}; frame-ancestors 'none'"
