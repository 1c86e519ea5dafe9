"""The recorder: listens to a real ROS 2 and puts what it hears on the time line.

This is the only module of the engine that imports rclpy. It runs one node, with a hidden random name, in a
thread of its own. Messages are kept as bytes, with the time at which the middleware received them here.
"""

from __future__ import annotations

import contextlib
import os
import secrets
import threading
from collections.abc import Callable, Iterator, Mapping
from itertools import count
from pathlib import Path
from types import TracebackType
from typing import Any

import rclpy
from rclpy.context import Context
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.exceptions import InvalidHandle
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import serialize_message
from rclpy.signals import SignalHandlerOptions
from rclpy.subscription import Subscription
from rclpy.utilities import get_rmw_implementation_identifier

from course.errors import OurFault
from course.evidence.graph_reader import GraphReader
from course.evidence.messages import UnknownType, full_definition
from course.evidence.recording import GRAPH_CUT, ROSOUT, ROSOUT_TYPE, UNREADABLE
from course.evidence.ros_services import Answer, Client, Parameters, Server, filled, load_type
from course.evidence.timeline import Timeline
from course.model.events import (
    GraphSeen,
    Joined,
    Marked,
    MessagesCut,
    MessageSeen,
    MessageSent,
    MessagesLost,
)
from course.model.feedback import Spoilt
from course.model.graph import Graph, Kind, infrastructure

DEPTH = 1000
# A node that publishes as fast as it can must not fill our memory; no check needs more.
MAX_MESSAGES = 50_000
MAX_BYTES = 64 * 1024 * 1024
# Each change stores the whole graph, so a program that creates topics endlessly could fill our memory.
MAX_ENDPOINTS = 200_000
GRAPH_PERIOD = 0.02
# Messages of one topic before the others get their turn.
AT_ONCE = 100


def load_middleware() -> None:
    """Load what every recorder needs, and start nothing."""
    get_rmw_implementation_identifier()
    load_type(ROSOUT_TYPE).__import_type_support__()


class Recorder:
    """Records ROS into `timeline` while its context is open."""

    def __init__(self, timeline: Timeline) -> None:
        self.timeline = timeline
        self.definitions: dict[str, str] = {}
        self.graph = Graph()
        self.numbers: Iterator[int] = count(1)
        self._context = Context()
        self._closing = False
        self._error: Exception | None = None
        self._listeners: dict[str, Listener] = {}
        self._watched: list[Callable[[], object]] = []
        self._watched_last: list[object] = []
        self._endpoints_kept = 0
        self._node: Node
        self._executor: SingleThreadedExecutor
        self._thread: threading.Thread
        self._reader: GraphReader

    def __enter__(self) -> Recorder:
        rclpy.init(context=self._context, signal_handler_options=SignalHandlerOptions.NO)
        self._node = Node(
            f"_ros2course_{secrets.token_hex(8)}",
            context=self._context,
            enable_rosout=False,
            start_parameter_services=False,
            # Its types alone load numpy, which takes a tenth of the CPU time of a check.
            parameter_overrides=[Parameter("start_type_description_service", value=False)],
        )
        self._reader = GraphReader(self._node)
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        self.subscribe(ROSOUT, ROSOUT_TYPE, durability="transient_local")
        self._node.create_timer(GRAPH_PERIOD, self._look_around)
        self._thread = threading.Thread(target=self._spin, name="recorder", daemon=True)
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._closing = True
        self._executor.shutdown(timeout_sec=1.0)
        self._context.try_shutdown()
        self._thread.join(timeout=2.0)
        self._node.destroy_node()
        if self._error is not None and error is None:
            # It failed on something that a program sent.
            raise Spoilt(f"the recorder stopped in the middle: {self._error}") from self._error

    def _spin(self) -> None:
        try:
            while not self._spin_until_garbage():
                pass
        except ExternalShutdownException:
            pass  # raised by rclpy when our own __exit__ ends it
        except Exception as error:  # noqa: BLE001 - raised by __exit__: a gap must not count against learners
            # A thread that is busy when we close finds its context gone.
            self._error = None if self._closing else error

    def _spin_until_garbage(self) -> bool:
        """True when spinning is over; False when a request or an answer is not valid UTF-8.

        rclpy itself decodes those, and a program's data must not stop us from listening.
        """
        try:
            self._executor.spin()
        except UnicodeDecodeError as error:
            self.timeline.add(Marked(self.timeline.now(), UNREADABLE, str(error)))
            return False
        return True

    def subscribe(
        self, topic: str, type_name: str, *, reliability: str = "reliable", durability: str = "volatile"
    ) -> Listener:
        """Record every message on `topic` from now on. Each topic has one listener.

        Asks for the given QoS first; if a publisher offers less, accepts what it offers. Raises OurFault if
        the grader's own ROS does not have this type.
        """
        if topic not in self._listeners:
            self.define(type_name)
            self._listeners[topic] = Listener(self, topic, type_name, reliability, durability)
            self._joined(topic, type_name, "subscription")
        return self._listeners[topic]

    def publisher(
        self, topic: str, type_name: str, *, reliability: str = "reliable", durability: str = "volatile"
    ) -> Stimulus:
        """A publisher of ours, whose messages are recorded as sent."""
        self.define(type_name)
        self._joined(topic, type_name, "publisher")
        return Stimulus(self, topic, type_name, _profile(reliability, durability))

    def _joined(self, topic: str, type_name: str, end: Kind) -> None:
        if not infrastructure(topic):
            self.timeline.add(Joined(self.timeline.now(), topic, type_name, end))

    def client(self, service: str, type_name: str) -> Client:
        """A client of our own."""
        return Client(self, service, type_name)

    def serve(self, service: str, type_name: str, answer: Answer) -> Server:
        """A server of our own."""
        return Server(self, service, type_name, answer)

    def parameters(self, node: str) -> Parameters:
        """Asks a node for its parameters, and listens to their changes."""
        return Parameters(self, node)

    def serialized(self, message: Any) -> bytes:
        """The message's CDR bytes."""
        return bytes(serialize_message(message))

    def watch(self, state: Callable[[], object]) -> None:
        """Wake up those who wait on the time line whenever `state()` has changed."""
        self._watched.append(state)

    def _look_around(self) -> None:
        self.look_at_graph()
        states = [state() for state in tuple(self._watched)]
        if states != self._watched_last:
            self._watched_last = states
            self.timeline.look_again()

    def look_at_graph(self) -> None:
        """Record the graph if it has changed."""
        graph = self._reader.read_if_changed()
        if graph is None or graph == self.graph:
            return
        self.graph = graph
        kept, self._endpoints_kept = self._endpoints_kept, self._endpoints_kept + len(graph.endpoints)
        if self._endpoints_kept <= MAX_ENDPOINTS:
            self.timeline.add(GraphSeen(self.timeline.now(), graph))
        elif kept <= MAX_ENDPOINTS:
            self.timeline.add(Marked(self.timeline.now(), GRAPH_CUT))

    def define(self, type_name: str) -> None:
        """Keep this type's text definition for readers of the recording."""
        if type_name not in self.definitions:
            prefixes = [Path(part) for part in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep)]
            try:
                self.definitions[type_name] = full_definition(type_name, prefixes)
            except UnknownType as error:
                raise OurFault(f"the grader does not know the message type {error}") from error

    @property
    def node(self) -> Node:
        return self._node

    @property
    def service_profile(self) -> QoSProfile:
        """For our ends of services: keeps all of many simultaneous calls."""
        return _profile("reliable", "volatile")


class Listener:
    """One recorded topic. `count`: messages received up to now."""

    def __init__(
        self, recorder: Recorder, topic: str, type_name: str, reliability: str, durability: str
    ) -> None:
        self.topic = topic
        self.type = type_name
        self.count = 0
        self._bytes = 0
        self._is_cut = False
        self._recorder = recorder
        self._wanted = (reliability, durability)
        self._round = 0
        self._subscription: Subscription[Any] | None = None
        self._open()

    def _open(self) -> None:
        self._round += 1
        this_round = self._round
        profile = _profile(*self._wanted)

        def receive(data: bytes, info: Mapping[str, Any]) -> None:
            if this_round == self._round:  # an earlier, stricter subscription is ignored from then on
                self._receive(data, info)
                self._receive_waiting()

        self._subscription = self._recorder.node.create_subscription(
            load_type(self.type), self.topic, receive, profile, raw=True, event_callbacks=self._events()
        )

    def close(self) -> None:
        """Stop listening, but keep what was received. For topics that repeat themselves."""
        self._round += 1
        if self._subscription is not None:
            self._recorder.node.destroy_subscription(self._subscription)

    def _receive_waiting(self) -> None:
        """Take everything else that has come in: rclpy would set up its whole wait again for each message."""
        subscription = self._subscription
        if subscription is None:  # it can receive before we have it
            return
        with contextlib.suppress(InvalidHandle), subscription.handle:  # closed meanwhile
            for _ in range(AT_ONCE):
                taken = subscription.handle.take_message(subscription.msg_type, True)
                if taken is None:
                    return
                self._receive(*taken)

    def _events(self) -> SubscriptionEventCallbacks:
        return SubscriptionEventCallbacks(
            message_lost=self._lost, incompatible_qos=self._incompatible, use_default_callbacks=False
        )

    def _receive(self, data: bytes, info: Mapping[str, Any]) -> None:
        self.count += 1
        self._bytes += len(data)
        if self.count > MAX_MESSAGES or self._bytes > MAX_BYTES:
            self._cut()
            return
        timeline = self._recorder.timeline
        moment = timeline.when(int(info["received_timestamp"]))
        timeline.add(MessageSeen(moment, self.topic, self.type, bytes(data)))

    def _cut(self) -> None:
        if not self._is_cut:
            self._is_cut = True
            timeline = self._recorder.timeline
            timeline.add(MessagesCut(timeline.now(), self.topic))

    def _lost(self, info: Any) -> None:
        timeline = self._recorder.timeline
        timeline.add(MessagesLost(timeline.now(), self.topic, int(info.total_count_change)))

    def _incompatible(self, info: Any) -> None:
        """A publisher offers less than we asked for, so ask for the least, which matches all."""
        if self._wanted != ("best_effort", "volatile"):
            self._wanted = ("best_effort", "volatile")
            self._open()


class Stimulus:
    """A publisher of the arena."""

    def __init__(self, recorder: Recorder, topic: str, type_name: str, profile: QoSProfile) -> None:
        self.topic = topic
        self.type = type_name
        self._timeline = recorder.timeline
        self._class = load_type(type_name)
        self._publisher = recorder.node.create_publisher(self._class, topic, profile)
        recorder.watch(lambda: self.matched)

    @property
    def matched(self) -> int:
        """How many subscriptions would receive a message now."""
        return int(self._publisher.get_subscription_count())

    def publish(self, **fields: Any) -> None:
        """Publish a message with these fields; pass nested messages as dicts."""
        data = serialize_message(filled(self._class(), fields))
        self._timeline.add(MessageSent(self._timeline.now(), self.topic, self.type, data))
        self._publisher.publish(data)


def _profile(reliability: str, durability: str) -> QoSProfile:
    return QoSProfile(
        depth=DEPTH,
        reliability=ReliabilityPolicy.get_from_short_key(reliability),
        durability=DurabilityPolicy.get_from_short_key(durability),
    )
