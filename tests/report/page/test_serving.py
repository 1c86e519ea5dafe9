"""The server: only for this machine, and read-only."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator
from http.client import HTTPConnection, HTTPResponse

import pytest

from course.errors import StorageError, UsageError
from course.report.page.data import as_json, submission_data
from course.report.page.html import live_page, news
from course.report.page.serving import HERE, PageServer, serving
from tests.report.page.classes import small


class Still:
    """A class in which nothing happens, until `broken`."""

    broken = False

    def page(self) -> str:
        if self.broken:
            raise StorageError("The disk is gone.", "Bring it back.")
        return live_page(small())

    def tag(self) -> str:
        return "t1"

    def news(self) -> tuple[str, str]:
        return "t1", as_json(news(small()))

    def submission(self, place: int) -> str | None:
        return as_json(submission_data(small(), place)) if place < 5 else None


@pytest.fixture
def still() -> Still:
    return Still()


@pytest.fixture
def server(still: Still) -> Iterator[PageServer]:
    with serving(still, 0) as server:
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        yield server
        server.shutdown()
        thread.join()


def ask(server: PageServer, path: str, method: str = "GET", **headers: str) -> tuple[HTTPResponse, bytes]:
    connection = HTTPConnection(HERE, server.server_port, timeout=30)
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    connection.request(method, path, headers=named)
    answer = connection.getresponse()
    body = answer.read()
    connection.close()
    return answer, body


def test_the_page_the_news_and_a_submission(server: PageServer) -> None:
    page, body = ask(server, server.root)
    assert page.status == 200 and b"Ada Okafor" in body
    answer, body = ask(server, f"{server.root}data.json")
    assert answer.status == 200 and len(json.loads(body)["data"]["people"]) == 5
    answer, body = ask(server, f"{server.root}submission/1.json")
    assert answer.status == 200 and json.loads(body)["name"] == "Bảo Nguyễn"


def test_it_listens_on_this_machine_alone(server: PageServer) -> None:
    assert server.server_address[0] == "127.0.0.1"
    assert server.address.startswith(f"http://127.0.0.1:{server.server_port}/")


@pytest.mark.parametrize("host", ["evil.example", "evil.example:{port}", "127.0.0.1", "127.0.0.1:1", ""])
def test_a_name_of_somebody_elses_gets_nothing(server: PageServer, host: str) -> None:
    answer, body = ask(server, server.root, Host=host.format(port=server.server_port))
    assert answer.status == 421 and b"Ada" not in body


def test_localhost_is_this_machine(server: PageServer) -> None:
    assert ask(server, server.root, Host=f"localhost:{server.server_port}")[0].status == 200


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE", "PATCH", "OPTIONS"])
def test_nothing_but_reading(server: PageServer, method: str) -> None:
    answer, _ = ask(server, server.root, method)
    assert answer.status == 405 and answer.headers["Allow"] == "GET, HEAD"


def test_head_is_the_same_without_the_page(server: PageServer) -> None:
    answer, body = ask(server, server.root, "HEAD")
    assert answer.status == 200 and int(answer.headers["Content-Length"]) > 1000 and body == b""


@pytest.mark.parametrize("path", ["/", "/data.json", "/submission/1.json", "/../etc/passwd", "/favicon.ico"])
def test_an_address_that_was_guessed_leads_nowhere(server: PageServer, path: str) -> None:
    answer, body = ask(server, path)
    assert answer.status == 404 and b"Ada" not in body


@pytest.mark.parametrize("name", ["submission/9.json", "submission/-1.json", "submission/x.json", "../x"])
def test_what_is_not_there_is_not_found(server: PageServer, name: str) -> None:
    assert ask(server, server.root + name)[0].status == 404


def test_nothing_new_is_nothing_sent(server: PageServer) -> None:
    first, _ = ask(server, f"{server.root}data.json")
    answer, body = ask(server, f"{server.root}data.json", If_None_Match=first.headers["ETag"])
    assert answer.status == 304 and body == b""


def test_browsers_are_told_to_be_careful(server: PageServer) -> None:
    answer, _ = ask(server, server.root)
    assert "default-src 'none'" in answer.headers["Content-Security-Policy"]
    assert answer.headers["X-Content-Type-Options"] == "nosniff"
    assert answer.headers["X-Frame-Options"] == "DENY"
    assert "Python" not in answer.headers["Server"]


def test_results_that_cannot_be_read_are_told(still: Still, server: PageServer) -> None:
    still.broken = True
    answer, body = ask(server, server.root)
    assert answer.status == 503 and body == b"The disk is gone."


def test_a_port_that_is_taken_is_told(server: PageServer, still: Still) -> None:
    with pytest.raises(UsageError, match="cannot be used"), serving(still, server.server_port):
        pass
