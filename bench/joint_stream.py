"""Does the recorder keep up with a robot's joint stream without loss, and with what share of a core?

A publisher in a separate process publishes at 500 Hz, then at 2 kHz, for ten seconds each, and numbers its
messages in their first joint. The baseline only keeps the same bytes: a bare rclpy subscription, spun by
rclpy's executor. Each listener is a separate process, one after the other in the same run. Ours waits as a
scenario does, which checks its condition after each message.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import struct
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from table import show

from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment, prepare

ROOT = Path(__file__).parents[1]
STATES = ("/myrobot_1/get/joint_states", "sensor_msgs/msg/JointState")
TARGETS = ("/myrobot_1/set/target_joint_positions", "std_msgs/msg/Float64MultiArray")
RATES = (500.0, 2000.0)
HEAD = ("message", "rate (Hz)", "listener", "sent", "lost", "of a core (%)", "MCAP (MB)")
# Replaced in the serialized bytes, so that the publisher needs almost no CPU.
MARK = 4711.0815
PUBLISHER = """
import struct, sys, time
import rclpy
from rclpy.qos import QoSProfile
from rclpy.serialization import serialize_message
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray
topic, kind, mark = sys.argv[1], sys.argv[2], float(sys.argv[3])
rate, seconds = float(sys.argv[4]), float(sys.argv[5])
values = [mark, 0.1, 0.2, 0.3, 0.4, 0.5]
message = JointState(position=values) if "JointState" in kind else Float64MultiArray(data=values)
rclpy.init()
node = rclpy.create_node("source", start_parameter_services=False)
publisher = node.create_publisher(type(message), topic, QoSProfile(depth=1000))
data = bytearray(serialize_message(message))
place = data.index(struct.pack("<d", mark))
while publisher.get_subscription_count() == 0:
    time.sleep(0.01)
time.sleep(0.5)
began = time.monotonic()
for number in range(round(rate * seconds)):
    time.sleep(max(0.0, began + number / rate - time.monotonic()))
    struct.pack_into("<d", data, place, number)
    publisher.publish(bytes(data))
print(number + 1, (number + 1) / (time.monotonic() - began), flush=True)
sys.stdin.read()  # until all of it has been received
"""


@dataclass(frozen=True)
class Heard:
    """numbers: of the messages, in order of arrival. cpu: seconds of CPU. size: bytes of the MCAP file."""

    numbers: list[int]
    cpu: float
    size: int


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--listen", nargs=4, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.listen:
        who, topic, kind, sent = options.listen
        print(json.dumps(vars({"recorder": recorder, "floor": floor}[who](topic, kind, int(sent)))))
    elif options.inside:
        print(json.dumps([row(*case, options.seconds) for case in cases()]))
    else:
        show(f"The joint stream for {options.seconds:.0f} s", HEAD, in_namespaces(options.seconds))


def cases() -> list[tuple[str, str, float, str]]:
    topics = (STATES, TARGETS)
    return [(*topic, rate, who) for topic in topics for rate in RATES for who in ("floor", "recorder")]


def in_namespaces(seconds: float) -> list[list[str]]:
    ros = find_ros()
    prepare(ros)
    with isolated() as where:
        environment = {**node_environment(ros), **where.environment}
        environment["PYTHONPATH"] += f":{ROOT}"
        command = [*where.prefix, sys.executable, __file__, "--inside", "--seconds", str(seconds)]
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True, text=True)
    return json.loads(done.stdout.splitlines()[-1])


def row(topic: str, kind: str, rate: float, who: str, seconds: float) -> list[str]:
    listener = [sys.executable, __file__, "--listen", who, topic, kind, str(round(rate * seconds))]
    source = [sys.executable, "-c", PUBLISHER, topic, kind, str(MARK), str(rate), str(seconds)]
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    with subprocess.Popen(source, **pipes) as publisher, subprocess.Popen(listener, **pipes) as hearing:
        sent, true = publisher.stdout.readline().split()
        heard = Heard(**json.loads(hearing.communicate()[0].splitlines()[-1]))
        publisher.communicate()
    lost = int(sent) - len(set(heard.numbers))
    share = 100 * heard.cpu / (int(sent) / float(true))
    size = f"{heard.size / 1e6:.2f}" if heard.size else "-"
    return [kind.split("/")[-1], f"{float(true):.0f}", who, sent, str(lost), f"{share:.1f}", size]


def floor(topic: str, kind: str, sent: int) -> Heard:
    """A bare raw subscription, spun by rclpy's executor in a separate thread."""
    import threading

    import rclpy
    from rclpy.executors import ExternalShutdownException
    from rclpy.qos import QoSProfile
    from rosidl_runtime_py.utilities import get_message

    rclpy.init()
    node = rclpy.create_node("floor", start_parameter_services=False)
    kept: list[bytes] = []
    node.create_subscription(get_message(kind), topic, kept.append, QoSProfile(depth=1000), raw=True)

    def spin() -> None:
        with contextlib.suppress(ExternalShutdownException):
            rclpy.spin(node)

    thread = threading.Thread(target=spin)
    thread.start()
    cpu = cpu_of(sent, lambda: len(kept), wait)
    rclpy.shutdown()
    thread.join()
    return Heard([number(data) for data in kept], cpu, 0)


def recorder(topic: str, kind: str, sent: int) -> Heard:
    from course.evidence.mcap_file import save
    from course.evidence.recorder import Recorder
    from course.evidence.recording import Recording
    from course.evidence.timeline import Timeline
    from course.model.events import MessageSeen

    timeline = Timeline()
    with Recorder(timeline) as ours:
        listener = ours.subscribe(topic, kind)
        cpu = cpu_of(sent, lambda: listener.count, timeline.wait_until)
        definitions = ours.definitions
    file = Path("/tmp", f"joint_stream_{time.monotonic_ns()}.mcap")
    recording = Recording("bench", timeline.events(), definitions, duration=timeline.now())
    save(recording, file, began_ns=time.time_ns())
    size = file.stat().st_size
    file.unlink()
    numbers = [number(event.data) for event in timeline.of(MessageSeen) if event.topic == topic]
    return Heard(numbers, cpu, size)


def cpu_of(sent: int, count: Callable[[], int], wait: Callable[[Callable[[], bool], float], object]) -> float:
    """CPU time of this process from the first message to the last; one second without any is the end."""
    wait(lambda: count() > 0, 60)
    began, heard = time.process_time(), 0
    while heard < count() < sent:
        heard = count()
        wait(lambda: count() >= sent, 1)
    return time.process_time() - began


def wait(condition: Callable[[], bool], timeout: float) -> None:
    """Wait without a timeline, by checking the condition every 10 ms."""
    last = time.monotonic() + timeout
    while not condition() and time.monotonic() < last:
        time.sleep(0.01)


def number(data: bytes) -> int:
    """The message's number, in the first of six joints: both types contain six doubles in a row."""
    rest = struct.pack("<5d", 0.1, 0.2, 0.3, 0.4, 0.5)
    place = data.index(rest) - 8
    return round(struct.unpack_from("<d", data, place)[0])


if __name__ == "__main__":
    main()
