"""Graders of chapter 20: a server, a client, and the rover's controller."""

from __future__ import annotations

import ast
import secrets
from functools import partial
from math import inf, isclose
from typing import Any

from course.api import (
    Arena,
    Call,
    Cause,
    Client,
    Failure,
    Feedback,
    Grader,
    Location,
    Process,
    Recording,
    Server,
    ServiceCall,
    Sources,
    about,
    calls,
    expect_answers,
    expect_clean_interrupt,
    expect_dependency,
    expect_endpoint,
    expect_node,
    expect_period,
    expect_qos,
    expect_running,
    expect_service,
    expect_service_type,
    expect_type,
    slips,
    text_places,
    trees,
    words,
)
from lib import rover
from lib.callers import expect_answers_logged, expect_calls, expect_patience, expect_waiting
from lib.counts import expect_counted, has_number
from lib.deliveries import first_reaction
from lib.interfaces import expect_same_service

PACKAGE = "python_package_that_uses_the_services"
INTERFACES = "package_with_interfaces"
TYPE = f"{INTERFACES}/srv/WhatIsThePoint"
HASHES = (
    "RIHS01_e87c30d67764861fc30a04b9d64414ff99bc5be6e31bdc2e5e5e18ea106f8ab4",
    "RIHS01_c11b8860d83662096ca56a010676029161709fabb468dace3e4f362bd1d2c29c",
)
SERVICE = "/what_is_the_point"
SERVER_NODE = "what_is_the_point_service_server"
CLIENT_NODE = "what_is_the_point_service_client"
SERVER = f"{SERVER_NODE}_node"
CLIENT = f"{CLIENT_NODE}_node"
COMPARE = (
    "Compare the fields with chapter 17: their names, types, and order. "
    "`ros2course check 17` shows the difference."
)
ANSWER = 42.0
PERIOD = 0.5
ENOUGH = 5
# If one kind of quote is missing among 20, the client does not choose at random.
AT_MOST = 20
LONGEST = 13.0
SILENT_FOR = 2.0
SHOWN = 3
COMES, SILENCE, AGAIN = "the service comes", "silence", "responds again"

server = Grader("20-server")
client = Grader("20-client")


def about_server(recording: Recording) -> Recording:
    """The server without the client, which is in the same package."""
    return about(recording, PACKAGE, SERVER, the_node(recording, SERVER_NODE))


def about_client(recording: Recording) -> Recording:
    return about(recording, PACKAGE, CLIENT, the_node(recording, CLIENT_NODE))


def the_node(recording: Recording, name: str) -> str:
    """The name of the only node that ran, even if that name is wrong."""
    nodes = recording.seen_nodes()
    return nodes[0].lstrip("/") if len(nodes) == 1 else name


# The server ------------------------------------------------------------------------------------------


@server.scenario
def nine_questions(arena: Arena) -> None:
    """Make one call to see whether the server responds, then eight more at once from two clients."""
    clients = (arena.ros.client(SERVICE, TYPE), arena.ros.client(SERVICE, TYPE))
    node = arena.run(PACKAGE, SERVER)
    if node and arena.until(lambda: arena.ros.graph.nodes, timeout=15, while_running=node):
        arena.until(lambda: offers_something(arena) or ready(*clients), timeout=8, while_running=node)
        if arena.until(lambda: ready(*clients), timeout=1, while_running=node):
            ask_all(arena, clients, node)
    arena.interrupt(node)


def ready(*clients: Client) -> bool:
    return all(one.available for one in clients)


def offers_something(arena: Arena) -> bool:
    return any(service.servers for service in arena.ros.graph.services)


def ask_all(arena: Arena, clients: tuple[Client, Client], node: Process) -> None:
    first, *others = quotes_about_life()
    clients[0].call(quote=first)
    if not arena.until(lambda: clients[0].answered, timeout=4, while_running=node):
        return
    for index, question in enumerate(others):
        clients[index % 2].call(quote=question)
    asked = len(others) + 1
    arena.until(lambda: sum(one.answered for one in clients) == asked, timeout=4, while_running=node)
    arena.until(lambda: has_counted(arena, node, asked), timeout=2, while_running=node)


def has_counted(arena: Arena, node: Process, number: int) -> bool:
    """Whether the node's output contains this number."""
    return any(has_number(line.rpartition("]: ")[2], number) for line in arena.lines(node))


@server.check("starts", "the node starts and keeps running")
def server_starts(recording: Recording) -> None:
    """Expect it to run until the first call. `answers` judges what follows."""
    own = about_server(recording)
    called = first_reaction(own, SERVER, (call.asked for call in own.service(SERVICE).calls))
    expect_running(own, SERVER, until=called)


@server.check("node_name", f"the node is called /{SERVER_NODE}", needs="starts")
def server_name(recording: Recording) -> None:
    expect_node(recording, f"/{SERVER_NODE}")


@server.check("offers", f"it offers the service {SERVICE}", needs="starts")
def offers(recording: Recording) -> None:
    remedy = f"Create it: `self.create_service(WhatIsThePoint, '{SERVICE}', self.callback)`."
    expect_service(about_server(recording), "server", SERVICE, remedy=remedy)


@server.check("right_type", f"the service's type is {TYPE}", needs="offers")
def server_type(recording: Recording) -> None:
    expect_service_type(about_server(recording), "server", SERVICE, TYPE)
    expect_same_service(recording, SERVICE, TYPE, HASHES, advice=COMPARE)


@server.check("answers", "it responds to each call, even from two clients at once", needs="right_type")
def answers(recording: Recording) -> None:
    expect_running(about_server(recording), SERVER)
    expect_answers(about_server(recording), SERVICE)


def total(call: ServiceCall) -> float:
    point = call.response.point
    return float(point.x + point.y + point.z)


def is_about_life(call: ServiceCall) -> bool:
    return "life" in call.request.quote.quote.lower()


def is_42(call: ServiceCall) -> bool:
    return isclose(total(call), ANSWER, rel_tol=0.0, abs_tol=1e-6)


def shown(call: ServiceCall) -> str:
    point = call.response.point
    return f"'{call.request.quote.quote}' -> x={point.x:g}, y={point.y:g}, z={point.z:g}: {total(call):g}"


def settings(recording: Recording) -> tuple[Location, ...]:
    """Where the program sets the response's point."""
    return tuple(place for axis in "xyz" for place in text_places(recording.sources, f"point.{axis} ="))[:1]


# Functions and flags that make a search ignore case.
FOLDS = {"lower", "upper", "casefold", "IGNORECASE", "I"}


def case_sensitive(sources: Sources) -> Cause | None:
    """The place of `'life' in text`, if nothing in the program ignores case."""
    found = [(file, node) for file, tree in trees(sources) for node in ast.walk(tree)]
    if any(isinstance(node, ast.Attribute) and node.attr in FOLDS for _, node in found):
        return None
    for file, node in found:
        if isinstance(node, ast.Constant) and node.value == "life":
            return Cause(
                "`'life' in text` does not find `Life` or `LIFE`. Look in `text.lower()` instead.",
                (Location(file, node.lineno),),
            )
    return None


def never_found(sources: Sources) -> Cause | None:
    """`'Life' in text.lower()`."""
    for file, tree in trees(sources):
        for node in ast.walk(tree):
            match node:
                case ast.Compare(
                    left=ast.Constant(value=str(word)),
                    comparators=[ast.Call(func=ast.Attribute(attr="lower" | "upper" as folds))],
                ) if getattr(word, folds)() != word:
                    return Cause(
                        f"After `.{folds}()`, no text contains `{word}`. Look for "
                        f"`{getattr(word, folds)()}` in it.",
                        (Location(file, node.lineno),),
                    )
    return None


@server.check("life", "quotes about life get a point whose sum is 42", points=2, needs="answers")
def life(recording: Recording) -> None:
    asked = [call for call in recording.service(SERVICE).calls if is_about_life(call)]
    wrong = [call for call in asked if not is_42(call)]
    if not wrong:
        return
    own = about_server(recording)
    some = len(wrong) < len(asked)
    cause = (
        case_sensitive(own.sources) if some else slips.first(own.sources, slips.other_response, never_found)
    )
    raise Failure(
        Feedback(
            summary=(
                f'"{wrong[0].request.quote.quote}" is about life, but x + y + z is {total(wrong[0]):g}.'
            ),
            expected="42",
            seen=f"{total(wrong[0]):g}",
            where=cause.where if cause else settings(own),
            advice=cause.text
            if cause
            else (
                "Look for `life` anywhere in `request.quote.quote.lower()`. Then choose any two "
                "numbers, and calculate the third one: 42 minus the first two."
            ),
            details=tuple(shown(call) for call in wrong[:SHOWN]),
        )
    )


@server.check("other", "other quotes get a point whose sum is not 42", needs="answers")
def other(recording: Recording) -> None:
    asked = [call for call in recording.service(SERVICE).calls if not is_about_life(call)]
    wrong = [call for call in asked if is_42(call)]
    if not wrong:
        return
    always = len(wrong) == len(asked) and all(map(is_42, recording.service(SERVICE).calls))
    raise Failure(
        Feedback(
            summary="x + y + z is 42 for every quote."
            if always
            else f'"{wrong[0].request.quote.quote}" is not about life, but x + y + z is 42.',
            expected="42 only for quotes that contain `life`",
            seen=shown(wrong[0]),
            where=settings(about_server(recording)),
            advice="Make the sum 42 only if `'life' in request.quote.quote.lower()` is true.",
        )
    )


@server.check("random", "that point is different each time", needs="answers")
def random_point(recording: Recording) -> None:
    asked = [call for call in recording.service(SERVICE).calls if not is_about_life(call)]
    points = {(call.response.point.x, call.response.point.y, call.response.point.z) for call in asked}
    if len(points) == len(asked):
        return
    own = about_server(recording)
    seeds = tuple(call.where for call in calls(own.sources, "seed"))[:1]
    lost = slips.other_response(own.sources)
    raise Failure(
        Feedback(
            summary="Every quote that is not about life gets the same point."
            if len(points) == 1
            else "The same quote gets the same point again. The point should be random each time.",
            expected="a random point at each call",
            seen=shown(asked[0]),
            where=lost.where if lost else seeds or settings(own),
            advice=lost.text
            if lost
            else "`random.seed` makes the same numbers come up again. Remove it."
            if seeds
            else "Call `random.uniform(0.0, 100.0)` in the callback, so that each call gets new numbers.",
        )
    )


@server.check("counts", "it logs the number of calls", needs="answers")
def counts(recording: Recording) -> None:
    expect_counted(about_server(recording), SERVER, len(recording.service(SERVICE).calls), what="calls")


@server.check("declares", "package.xml declares rclpy and package_with_interfaces")
def server_dependencies(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclpy", INTERFACES)


@server.check("interrupt", "Ctrl+C ends it cleanly", needs="answers")
def server_interrupt(recording: Recording) -> None:
    expect_clean_interrupt(about_server(recording), SERVER)


# The client ------------------------------------------------------------------------------------------


@client.scenario
def late_then_silent(arena: Arena) -> None:
    """Start the service after the client has logged that it waits. Later, stop responding for a while."""
    node = arena.run(PACKAGE, CLIENT)
    if node and arena.until(lambda: arena.ros.graph.nodes, timeout=15, while_running=node):
        arena.until(lambda: arena.logged(""), timeout=6, while_running=node)
        arena.mark(COMES)
        oracle = Oracle()
        shop = arena.ros.serve(SERVICE, TYPE, oracle)
        if serve_enough(arena, shop, oracle, node):
            fall_silent(arena, shop, oracle, node)
    arena.interrupt(node)


def serve_enough(arena: Arena, shop: Server, oracle: Oracle, node: Process) -> bool:
    """Serve until both kinds of quotes have come. Return whether the last response reached the log."""
    end = arena.timeline.now() + LONGEST
    while not enough(shop, oracle) and node.running and arena.timeline.now() < end:
        if not arena.until(partial(more_than, shop, shop.requests), timeout=3, while_running=node):
            return False
    if not oracle.given:
        return False
    last = oracle.given[-1]  # keep this one: a node that logs an answer at its next call is always one behind
    return arena.until(lambda: is_logged(arena, last), timeout=3, while_running=node)


def more_than(shop: Server, number: int) -> bool:
    return shop.requests > number


def enough(shop: Server, oracle: Oracle) -> bool:
    return shop.requests >= ENOUGH and (len(oracle.about_life) == 2 or shop.requests >= AT_MOST)


def is_logged(arena: Arena, point: tuple[str, ...]) -> bool:
    return all(arena.logged(number) for number in point)


def fall_silent(arena: Arena, shop: Server, oracle: Oracle, node: Process) -> None:
    """Two more requests show that the client continues. Then one more response must reach its log."""
    before = shop.requests
    arena.mark(SILENCE)
    shop.pause()
    arena.until(lambda: shop.requests >= before + 2, timeout=SILENT_FOR, while_running=node)
    given = len(oracle.given)
    arena.mark(AGAIN)
    shop.resume()
    arena.until(
        lambda: any(is_logged(arena, point) for point in oracle.given[given:]), timeout=8, while_running=node
    )


def moment(recording: Recording, mark: str) -> float:
    """When the scenario reached this point, or infinity if it did not."""
    found = recording.marked(mark)
    return found.t if found else inf


@client.check("starts", "the node starts and keeps running")
def client_starts(recording: Recording) -> None:
    """Expect it to run until its first call. `survives` judges what follows."""
    asked = recording.service(SERVICE).requests
    expect_running(about_client(recording), CLIENT, until=asked[0].asked if asked else inf)


@client.check("node_name", f"the node is called /{CLIENT_NODE}", needs="starts")
def client_name(recording: Recording) -> None:
    expect_node(recording, f"/{CLIENT_NODE}")


@client.check("uses", f"it has a client of {SERVICE}", needs="starts")
def uses(recording: Recording) -> None:
    remedy = f"Create it in `__init__`: `self.create_client(WhatIsThePoint, '{SERVICE}')`."
    expect_service(about_client(recording), "client", SERVICE, remedy=remedy)


@client.check("right_type", f"the service's type is {TYPE}", needs="uses")
def client_type(recording: Recording) -> None:
    expect_service_type(about_client(recording), "client", SERVICE, TYPE)


@client.check("waits", "it logs that it is waiting while there is no service", needs="right_type")
def waits(recording: Recording) -> None:
    expect_waiting(about_client(recording), CLIENT, moment(recording, COMES))


@client.check("survives", "it keeps running while it calls", needs="right_type")
def survives(recording: Recording) -> None:
    expect_running(about_client(recording), CLIENT)


@client.check("asks", "it calls the service again and again", needs="survives")
def asks(recording: Recording) -> None:
    since = moment(recording, COMES)
    expect_calls(about_client(recording), CLIENT, SERVICE, at_least=ENOUGH, period=PERIOD, since=since)


@client.check("rate", "it calls twice per second", needs="asks")
def rate(recording: Recording) -> None:
    times = tuple(call.asked for call in answered_ones(recording))
    expect_period(times, PERIOD, what="calls", program=about_client(recording))


def answered_ones(recording: Recording) -> tuple[ServiceCall, ...]:
    """The calls before the arena's pause that got a response."""
    until = moment(recording, SILENCE)
    return tuple(call for call in recording.service(SERVICE).requests if call.answered and call.asked < until)


def digits(call: ServiceCall) -> dict[str, str]:
    """The digits that must be in the log. The scenario's numbers are whole, so these are all their digits."""
    return {axis: str(int(getattr(call.response.point, axis))) for axis in "xyz"}


def filling(own: Recording) -> tuple[Location, ...]:
    """Where the program sets the request's quote."""
    places = (*text_places(own.sources, "quote.quote ="), *text_places(own.sources, "quote="))
    return places[:1] or tuple(call.where for call in calls(own.sources, "call_async"))[:1]


@client.check("quotes", "every request contains a quote", needs="asks")
def quotes(recording: Recording) -> None:
    requests = recording.service(SERVICE).requests
    empty = [call for call in requests if not call.request.quote.quote.strip()]
    if empty:
        raise Failure(
            Feedback(
                summary="The quote in the request is empty.",
                expected="a string in `request.quote.quote`",
                seen=f"an empty string in {len(empty)} of {len(requests)} requests",
                where=filling(about_client(recording)),
                advice=(
                    "Set it before the call: `request.quote.quote = '...'`. The request's only field, "
                    "`quote`, is an `AmazingQuote`."
                ),
            )
        )


@client.check("both_kinds", "some quotes are about life, and some are not", needs="quotes")
def both_kinds(recording: Recording) -> None:
    asked = [call.request.quote.quote for call in recording.service(SERVICE).requests]
    kinds = {"life" in quote.lower() for quote in asked}
    if len(kinds) == 2:
        return
    raise Failure(
        Feedback(
            summary=f"None of the {len(asked)} quotes contains the word `life`."
            if kinds == {False}
            else f"All {len(asked)} quotes contain the word `life`.",
            expected="both kinds",
            seen=asked[0][:120],
            where=filling(about_client(recording)),
            advice="Alternate between two quotes, or choose one for each call: `random.choice([..., ...])`.",
            details=tuple(dict.fromkeys(asked))[:SHOWN],
        )
    )


@client.check("logs", "it logs x, y, and z of each response", points=2, needs="asks")
def logs(recording: Recording) -> None:
    expect_answers_logged(about_client(recording), CLIENT, answered_ones(recording), digits)


@client.check("goes_on", "it continues when a response does not arrive", points=2, needs="logs")
def goes_on(recording: Recording) -> None:
    expect_patience(about_client(recording), CLIENT, SERVICE, moment(recording, AGAIN), PERIOD, digits)


@client.check("declares", "package.xml declares rclpy and package_with_interfaces")
def client_dependencies(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclpy", INTERFACES)


@client.check("interrupt", "Ctrl+C ends it cleanly", needs="survives")
def client_interrupt(recording: Recording) -> None:
    expect_clean_interrupt(about_client(recording), CLIENT)


def quotes_about_life() -> list[dict[str, Any]]:
    """Nine AmazingQuotes: five contain `life` in some spelling, and two of the others are the same."""
    same = words(4)
    texts = [
        f"{words(2)} that is life",
        same,
        f"Life {words(3)}",
        "",
        f"{words(2)} THE MEANING OF LIFE",
        same,
        f"{words(1)} of a lifetime {words(1)}",
        f"{words(2)} «häufig», 日本語",
        f"{words(2)} liFE, {words(1)}",
    ]
    start = 10_000 + secrets.randbelow(80_000)
    return [
        {"id": start + index, "quote": text, "philosopher_name": f"Professor {words(1)}"}
        for index, text in enumerate(texts)
    ]


class Oracle:
    """Responds to each request with an unpredictable point, and remembers what it was asked and what it said.

    about_life: which kinds of quote came. given: the digits of each point's x, y, and z. The numbers
    are whole, so every way to format a float shows these digits.
    """

    def __init__(self) -> None:
        self.about_life: set[bool] = set()
        self.given: list[tuple[str, ...]] = []

    def __call__(self, request: Any) -> dict[str, Any]:
        numbers = [1000 + secrets.randbelow(9000) for _ in "xyz"]
        self.about_life.add("life" in request.quote.quote.lower())
        self.given.append(tuple(map(str, numbers)))
        return {"point": dict(zip("xyz", map(float, numbers), strict=True))}


# The rover's controller ------------------------------------------------------------------------------

CONTROLLER = f"{rover.CONTROLLER}_node"
STOPPED, FREE = "told to stop", "told to drive again"
AFTER = {STOPPED: 4.0, FREE: 5.0}  # m, the distance that the sensor then measures

controller = Grader("20-rover")


@controller.scenario
def approach_and_stop(arena: Arena) -> None:
    """Play the sensor: publish a few distances. Then tell the rover to stop, and to drive again."""
    commands = arena.ros.subscribe(rover.COMMAND, rover.COMMAND_TYPE)
    sensor = arena.ros.publisher(rover.RANGE, rover.RANGE_TYPE)
    stop = arena.ros.client(rover.STOP, rover.STOP_TYPE)
    node = arena.run(rover.PACKAGE, CONTROLLER)
    if node and arena.until(lambda: sensor.matched and arena.ros.graph.nodes, timeout=15, while_running=node):
        rover.measure(arena, sensor.publish, commands, node, *rover.distances())
        if arena.until(lambda: stop.available, timeout=3, while_running=node):
            for phase, order in ((STOPPED, True), (FREE, False)):
                call = stop.call(data=order)
                arena.until(partial(is_done, call), timeout=3, while_running=node)
                arena.mark(phase)
                rover.measure(arena, sensor.publish, commands, node, AFTER[phase], AFTER[phase])
    arena.interrupt(node)


def is_done(call: Call) -> bool:
    return call.done


def about_controller(recording: Recording) -> Recording:
    return about(recording, rover.PACKAGE, CONTROLLER, rover.CONTROLLER)


@controller.check("starts", "the node starts and keeps running")
def controller_starts(recording: Recording) -> None:
    sent = first_reaction(recording, CONTROLLER, (message.t for message in recording.sent(rover.RANGE)))
    expect_running(about_controller(recording), CONTROLLER, until=sent)


@controller.check("node_name", f"the node is called /{rover.CONTROLLER}", needs="starts")
def controller_name(recording: Recording) -> None:
    expect_node(recording, f"/{rover.CONTROLLER}")


@controller.check("subscribes", f"it subscribes to {rover.RANGE}", needs="starts")
def controller_subscribes(recording: Recording) -> None:
    remedy = f"Subscribe: `self.create_subscription(Range, '{rover.RANGE}', self.range_callback, 10)`."
    expect_endpoint(about_controller(recording), "subscription", rover.RANGE, remedy=remedy)
    expect_type(recording, "subscription", rover.RANGE, rover.RANGE_TYPE)
    expect_qos(recording, rover.RANGE)


@controller.check("publishes", f"it publishes on {rover.COMMAND}", needs="starts")
def controller_publishes(recording: Recording) -> None:
    remedy = f"Create a publisher: `self.create_publisher(Twist, '{rover.COMMAND}', 10)`."
    expect_endpoint(about_controller(recording), "publisher", rover.COMMAND, remedy=remedy)
    expect_type(recording, "publisher", rover.COMMAND, rover.COMMAND_TYPE)


@controller.check("offers", f"it offers the service {rover.STOP}", needs="starts")
def controller_offers(recording: Recording) -> None:
    remedy = f"Create it: `self.create_service(SetBool, '{rover.STOP}', self.stop_callback)`."
    expect_service(about_controller(recording), "server", rover.STOP, remedy=remedy)
    expect_service_type(about_controller(recording), "server", rover.STOP, rover.STOP_TYPE)


@controller.check("survives", "it keeps running while messages arrive", needs=("subscribes", "publishes"))
def controller_survives(recording: Recording) -> None:
    expect_running(about_controller(recording), CONTROLLER)


@controller.check("speed", "it commands the speed that the library returns", points=2, needs="survives")
def commands_speed(recording: Recording) -> None:
    for distance, speed in rover.answered_distances(recording, -inf, told_at(recording, 0)):
        advice = "Pass `message.range` to `safe_speed`."
        rover.expect_speed(about_controller(recording), distance, speed, rover.safe_speed(distance), advice)


@controller.check(
    "stops", f"after a call to {rover.STOP} with true, the rover stops", needs=("speed", "offers")
)
def stops(recording: Recording) -> None:
    expect_answers(about_controller(recording), rover.STOP)
    told = recording.marked(STOPPED)
    advice = (
        "Store `request.data` in `self`. As long as it is true, publish a `Twist` with speed 0.0 after "
        "each measurement."
    )
    for distance, speed in rover.answered_distances(
        recording, told.t if told else -inf, told_at(recording, 1)
    ):
        rover.expect_speed(about_controller(recording), distance, speed, 0.0, advice)


@controller.check("drives_again", "after a call with false, it drives again", needs="stops")
def drives_again(recording: Recording) -> None:
    free = recording.marked(FREE)
    advice = "Store `request.data` in `self` at each call, so that a call with `false` ends the stop."
    for distance, speed in rover.answered_distances(recording, free.t if free else -inf, inf):
        rover.expect_speed(about_controller(recording), distance, speed, rover.safe_speed(distance), advice)


@controller.check("says_success", "its response reports success", needs="stops")
def says_success(recording: Recording) -> None:
    for call in recording.service(rover.STOP).calls:
        if not call.response.success:
            raise Failure(
                Feedback(
                    summary="The response says that the call failed.",
                    expected="success is True",
                    seen="success is False",
                    where=text_places(recording.sources, "return response")[:1],
                    advice="Set `response.success = True` before you return the response.",
                )
            )


def told_at(recording: Recording, number: int) -> float:
    """When the service was called for call `number`, from 0. A correct node may stop the rover at once."""
    calls_so_far = recording.service(rover.STOP).calls
    return calls_so_far[number].asked if len(calls_so_far) > number else inf


@controller.check("declares", "package.xml declares every package that the node imports from")
def controller_dependencies(recording: Recording) -> None:
    expect_dependency(recording, rover.PACKAGE, "rclpy", "sensor_msgs", "geometry_msgs", "std_srvs")


@controller.check("interrupt", "Ctrl+C ends it cleanly", needs="survives")
def controller_interrupt(recording: Recording) -> None:
    expect_clean_interrupt(about_controller(recording), CONTROLLER)
