"""Runs with ROS: a node with services and parameters, and the recorder as client and server; prints JSON."""

import contextlib
import json
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.context import Context
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from std_srvs.srv import SetBool, Trigger

from course.evidence.mcap_file import load, save
from course.evidence.recorder import Recorder
from course.evidence.recording import UNREADABLE, Recording
from course.evidence.timeline import Timeline

WAIT = 20.0
SET = "std_srvs/srv/SetBool"
TRIGGER = "std_srvs/srv/Trigger"

timeline = Timeline()
context = Context()
rclpy.init(context=context)
found: dict[str, object] = {}


def switch(request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
    response.success = not request.data
    response.message = "häufig"
    return response


def refuse(parameters: list[Parameter]) -> SetParametersResult:
    bad = [p for p in parameters if p.name == "period"]
    return SetParametersResult(successful=not bad, reason="the period is fixed" if bad else "")


def await_true(condition: Callable[[], bool]) -> bool:
    """Changes in the talker alone are not events of the recorder, so look often."""
    end = timeline.now() + WAIT
    while not condition() and timeline.now() < end:
        timeline.wait_until(condition, 0.05)
    return condition()


def await_event(condition: Callable[[], bool]) -> bool:
    """The recorder itself must wake us: half the timeout is too late."""
    began = timeline.now()
    return timeline.wait_until(condition, WAIT) and timeline.now() - began < WAIT / 2


def answer(request: object) -> dict[str, object] | None:
    return {"success": True, "message": f"answer {server.requests}"}


with Recorder(timeline) as recorder:
    first = recorder.client("/switch", SET)
    second = recorder.client("/switch", SET)
    nobody = recorder.client("/nobody", SET)
    parameters = recorder.parameters("/robot/talker")
    server = recorder.serve("/trigger", TRIGGER, answer)
    found["before"] = [first.available, parameters.available]

    talker = Node("talker", context=context, namespace="/robot")
    talker.declare_parameter("quote", "a")
    talker.declare_parameter("period", 0.5)
    talker.declare_parameter("sizes", [1, 2])
    talker.create_service(SetBool, "/switch", switch)
    talker.add_on_set_parameters_callback(refuse)
    asker = talker.create_client(Trigger, "/trigger")
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(talker)

    def spin() -> None:
        with contextlib.suppress(ExternalShutdownException):
            executor.spin()

    thread = threading.Thread(target=spin)
    thread.start()

    # the arena asks
    found["woken"] = [await_event(lambda: first.available and second.available)]
    calls = [client.call(data=bool(n % 2)) for n in range(4) for client in (first, second)]
    found["all answered"] = await_true(lambda: all(call.done for call in calls))
    found["response"] = calls[0].response.message
    found["counts"] = [first.answered, second.answered, nobody.available]

    # the arena is asked
    found["woken"] += [await_event(lambda: server.clients == 1)]
    await_true(asker.service_is_ready)
    await_true(lambda: any(s.clients for s in recorder.graph.services))
    found["services"] = [
        [s.name, s.type, bool(s.request_hash), s.servers, s.clients] for s in recorder.graph.services
    ]
    answers = [asker.call_async(Trigger.Request())]
    found["first answer"] = await_true(lambda: answers[0].done())
    server.pause()
    answers.append(asker.call_async(Trigger.Request()))
    await_true(lambda: server.requests == 2)
    server.resume()
    answers.append(asker.call_async(Trigger.Request()))
    found["third answer"] = await_true(lambda: answers[2].done())
    found["second answer"] = answers[1].done()
    found["answers"] = [answers[0].result().message, answers[2].result().message]

    # parameters
    await_true(lambda: parameters.available)
    asked = [*parameters.get("quote", "period", "sizes", "qoute"), parameters.list()]
    asked += parameters.describe("quote")
    await_true(lambda: all(call.done for call in asked))
    changed = parameters.set(quote="0.5", period=2.0)
    await_true(lambda: changed.done)
    unknown = parameters.set({"not.there": 1})
    await_true(lambda: unknown.done)
    again = parameters.get("quote")[0]
    await_true(lambda: again.done)
    found["announced"] = await_true(lambda: recorder.subscribe("/parameter_events", "").count > 0)

    # a server that goes away, and one that comes back
    server.close()
    found["gone"] = await_true(lambda: not asker.service_is_ready())
    server = recorder.serve("/trigger", TRIGGER, answer)
    found["back"] = await_true(lambda: asker.service_is_ready())

    # garbage from others does not make the recorder deaf
    def garbage() -> None:
        timer.cancel()
        b"\xff".decode()

    timer = recorder.node.create_timer(0.01, garbage)
    await_true(lambda: any(getattr(e, "name", "") == UNREADABLE for e in timeline.events()))
    after = first.call(data=True)
    found["still hears"] = await_true(lambda: after.done)

    recording = Recording("x", timeline.events(), recorder.definitions, duration=timeline.now())

context.try_shutdown()
thread.join()

file = Path(sys.argv[1])
save(recording, file, began_ns=1_700_000_000_000_000_000)
loaded = load(file)
found["the same"] = loaded == recording
view = loaded.service("/switch")
found["calls"] = [[c.client, c.request.data, c.response.success, c.response.message] for c in view.calls[:2]]
found["in order"] = all(c.answered is not None and c.answered >= c.asked for c in view.calls)
found["clients"] = sorted({c.client for c in view.calls})
requests = loaded.service("/trigger").requests
found["requests"] = [[c.client, c.response and c.response.message] for c in requests]
found["request times"] = [c.asked for c in requests] == sorted(c.asked for c in requests)
known = loaded.parameters("/robot/talker")
found["names"] = [name for name in known.names if name != "start_type_description_service"]
found["at first"] = {p.name: [p.type, p.value] for p in known.at(known.sets[0].asked).values()}
found["at last"] = known.get("quote").value  # type: ignore[union-attr]
found["undeclared"] = known.undeclared
found["sets"] = [[s.name, s.type, s.value, s.successful, s.reason] for s in known.sets]
found["changes"] = [[p.name, p.type, p.value] for p in known.changes if p.value == "0.5"]
found["described"] = known.descriptors["quote"].type
found["unasked"] = [loaded.parameters("/x").asked, loaded.parameters("/x").answered, known.answered]
print(json.dumps(found))
