"""What is wrong with a server or a client."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.explain.engine import Cause
from course.explain.python_slips import standstill
from course.explain.service_causes import (
    blocking_call,
    fields_of_the_request,
    no_response,
    not_the_response,
    result_too_early,
    sleeping,
    spin_in_callback,
)

FILE = "src/talk/talk/talker.py"
SERVE = "create_service(T, 'x', self.answer)\ndef answer(self, request, reply):\n"
TICK = "create_timer(1.0, self.tick)\ndef tick(self):\n"


def sources(text: str) -> Sources:
    return Sources({FILE: text})


def at(cause: Cause | None) -> list[str]:
    assert cause is not None
    return [str(place).removeprefix(f"{FILE}:") for place in cause.where]


@pytest.mark.parametrize(
    "body",
    [
        "    pass\n",
        "    return\n",
        "    return None\n",
        "    if request.x:\n        return reply\n",
        "    if request.x:\n        return reply\n    else:\n        reply.x = 1\n",
        "    try:\n        return reply\n    except ValueError:\n        pass\n",
    ],
)
def test_no_response(body: str) -> None:
    cause = no_response(sources(SERVE + body))
    assert at(cause) == ["2"]
    assert "`return reply`" in str(cause)


@pytest.mark.parametrize(
    "body",
    [
        "    return reply\n",
        "    return T.Response()\n",
        "    if request.x:\n        return reply\n    else:\n        return reply\n",
        "    if request.x:\n        return reply\n    raise ValueError\n",
        "    with self.lock:\n        return reply\n",
        "    try:\n        pass\n    finally:\n        return reply\n",
        "    try:\n        return reply\n    except ValueError:\n        return reply\n",
    ],
)
def test_a_response_whichever_way(body: str) -> None:
    assert no_response(sources(SERVE + body)) is None


def test_something_else_is_returned() -> None:
    cause = not_the_response(sources(SERVE + "    return request\n"))
    assert at(cause) == ["3"]
    assert "It must return `reply`" in str(cause)
    assert not_the_response(sources(TICK + "    return 1\n")) is None


def test_other_callbacks_need_return_nothing() -> None:
    assert no_response(sources(TICK + "    pass\n")) is None


def test_a_field_of_the_request() -> None:
    cause = fields_of_the_request(sources(SERVE + "    request.point.x = 1.0\n    return reply\n"))
    assert at(cause) == ["3"]
    assert "`request.point.x`" in str(cause)
    assert "`reply.point.x`" in str(cause)
    assert fields_of_the_request(sources(SERVE + "    reply.x = request.x\n    return reply\n")) is None


@pytest.mark.parametrize(
    ("call", "explain", "words"),
    [
        ("self.client.call(request)", blocking_call, "`call_async`"),
        ("rclpy.spin_until_future_complete(self, f)", spin_in_callback, "`spin_until_future_complete`"),
        ("rclpy.spin_once(self)", spin_in_callback, "`spin_once`"),
        ("time.sleep(1)", sleeping, "`sleep`"),
    ],
)
def test_what_does_not_belong_into_a_callback(call: str, explain: object, words: str) -> None:
    cause = explain(sources(f"{TICK}    {call}\n"))  # type: ignore[operator]
    assert at(cause) == ["3"]
    assert words in cause.text
    assert explain(sources(f"{TICK}    pass\ndef main():\n    {call}\n")) is None  # type: ignore[operator]


def test_a_standstill() -> None:
    assert at(standstill(sources(f"{TICK}    self.client.call(request)\n"))) == ["3"]
    assert at(standstill(sources(f"{TICK}    rclpy.spin_once(self)\n"))) == ["3"]
    assert standstill(sources(f"{TICK}    self.client.call_async(request)\n")) is None


def test_a_result_that_is_read_too_early() -> None:
    assert at(result_too_early(sources("\npoint = self.future.result().point\n"))) == ["2"]
    assert result_too_early(sources("self.future.done()")) is None
