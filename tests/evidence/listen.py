"""Runs with ROS: a node talks, the recorder listens, and what it recorded is printed as JSON."""

import json

import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import deserialize_message
from std_msgs.msg import Header, String

from course.errors import OurFault
from course.evidence import recorder as module
from course.evidence.recorder import Recorder
from course.evidence.recording import ROSOUT, Recording
from course.evidence.timeline import Timeline
from course.model.events import GraphSeen, Joined, MessagesCut, MessageSeen, MessageSent

WAIT = 20.0
STRING = "std_msgs/msg/String"
module.MAX_MESSAGES = 5

timeline = Timeline()
context = Context()
rclpy.init(context=context)
talker = Node("talker", context=context, namespace="/robot")
found: dict[str, object] = {}


def topic(event: object) -> str | None:
    return getattr(event, "topic", None)


def count(name: str) -> int:
    return sum(1 for event in timeline.of(MessageSeen) if topic(event) == name)


def await_messages(name: str, number: int = 1) -> bool:
    return timeline.wait_until(lambda: count(name) >= number, WAIT)


with Recorder(timeline) as recorder:
    for name in ("/reliable", "/best_effort", "/flood"):
        recorder.subscribe(name, STRING)
    recorder.subscribe("/early", STRING, durability="transient_local")
    same = recorder.subscribe("/reliable", STRING)
    found["one listener"] = same is recorder.subscribe("/reliable", STRING)

    profiles = {
        "/reliable": QoSProfile(depth=10),
        "/best_effort": QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT),
        "/early": QoSProfile(depth=10, durability=DurabilityPolicy.VOLATILE),
        "/flood": QoSProfile(depth=100),
    }
    publishers = {name: talker.create_publisher(String, name, profile) for name, profile in profiles.items()}
    for name, publisher in publishers.items():
        # A listener that requested too much requests again; until then, messages do not reach it.
        number = 0
        while count(name) < (8 if name == "/flood" else 2) and number < 400:
            publisher.publish(String(data=f"{name} {number}"))
            number += 1
            timeline.wait_until(lambda: False, 0.05)
            if name == "/flood" and any(timeline.of(MessagesCut)):
                break
    found["counts"] = {name: count(name) >= 2 for name in publishers}
    found["cut"] = [event.topic for event in timeline.of(MessagesCut)]
    found["kept of the flood"] = count("/flood")

    talker.get_logger().info("häufig")
    found["logged"] = await_messages(ROSOUT)

    stimulus = recorder.publisher("/header", "std_msgs/msg/Header")
    heard: list[Header] = []
    talker.create_subscription(Header, "/header", heard.append, 10)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(talker)
    for _ in range(400):
        if stimulus.matched:
            break
        executor.spin_once(timeout_sec=0.05)
    stimulus.publish(frame_id="arm", stamp={"sec": 5, "nanosec": 7})
    for _ in range(400):
        if heard:
            break
        executor.spin_once(timeout_sec=0.05)
    found["heard"] = [(header.frame_id, header.stamp.sec, header.stamp.nanosec) for header in heard]
    (sent,) = timeline.of(MessageSent)
    found["sent"] = deserialize_message(sent.data, Header).frame_id

    found["joined"] = [(event.topic, event.end) for event in timeline.of(Joined)]

    module.MAX_MESSAGES, most = 1000, module.MAX_MESSAGES
    burst, again = recorder.subscribe("/burst", STRING), recorder.subscribe("/again", STRING)
    bursting, saying = (
        talker.create_publisher(String, name, QoSProfile(depth=200)) for name in ("/burst", "/again")
    )
    for publisher in (bursting, saying):
        for _ in range(400):
            if publisher.get_subscription_count():
                break
            timeline.wait_until(lambda: False, 0.05)
    for number in range(150):
        bursting.publish(String(data=str(number)))
    timeline.wait_until(lambda: burst.count >= 150, WAIT)
    saying.publish(String(data="before"))
    timeline.wait_until(lambda: again.count >= 1, WAIT)
    again.close()
    saying.publish(String(data="after"))
    bursting.publish(String(data="last"))
    timeline.wait_until(lambda: burst.count > 150, WAIT)
    module.MAX_MESSAGES = most

    timeline.wait_until(lambda: "/robot/talker" in recorder.graph.nodes, WAIT)
    found["nodes"] = recorder.graph.nodes
    for name in ("no_such_package/msg/String", "std_msgs/msg/Strin"):
        try:
            recorder.subscribe("/x", name)
        except OurFault as error:
            found[name] = error.what
    found["graphs"] = any(timeline.of(GraphSeen))
    module.MAX_ENDPOINTS, kept = 0, len(list(timeline.of(GraphSeen)))
    for name in ("/more", "/and_more"):
        talker.create_publisher(String, name, 1)
        timeline.wait_until(lambda name=name: name in recorder.graph.topics_of("publisher"), WAIT)
    found["graphs kept after the cut"] = len(list(timeline.of(GraphSeen))) - kept
    found["still looking"] = "/and_more" in recorder.graph.topics_of("publisher")
    recording = Recording("x", timeline.events(), recorder.definitions)

found["log"] = [(line.node, line.level, line.text) for line in recording.log]
found["first"] = recording.messages("/reliable")[0].data.data.startswith("/reliable ")
found["burst"] = [message.data.data for message in recording.messages("/burst")]
found["after it was closed"] = [message.data.data for message in recording.messages("/again")]
found["in time"] = all(0.0 <= event.t <= timeline.now() for event in recording.events)
talker.destroy_node()
context.try_shutdown()
print(json.dumps(found))
