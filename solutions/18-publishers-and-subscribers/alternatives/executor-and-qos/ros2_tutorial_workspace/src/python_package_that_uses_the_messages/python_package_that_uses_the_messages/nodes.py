import time

from package_with_interfaces.msg import AmazingQuote
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy, qos_profile_sensor_data


class QuoteNode(Node):
    topic = '/amazing_quote'

    def wake_up(self):
        for word in ('Waking up.', 'Not yet ready.', 'Ready.'):
            self.get_logger().warn(word)
            print(word)
            time.sleep(0.4)


class Talker(QuoteNode):
    def __init__(self, name):
        super().__init__(name)
        self.wake_up()
        qos = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
        self._pub = self.create_publisher(AmazingQuote, self.topic, qos)
        self._sent = 0
        self.create_timer(0.5, self._send)

    def _send(self):
        msg = AmazingQuote(id=self._sent)
        msg.quote, msg.philosopher_name = f'Quote no. {self._sent}', 'Talker'
        self._pub.publish(msg)
        self.get_logger().info(f'sent {msg.id}')
        self._sent = self._sent + 1


class Listener(QuoteNode):
    def __init__(self, name):
        super().__init__(name)
        self.wake_up()
        self.create_subscription(
            msg_type=AmazingQuote, topic=self.topic, callback=self._heard,
            qos_profile=qos_profile_sensor_data)

    def _heard(self, msg, info):
        self.get_logger().info(f'{msg.philosopher_name}, no. {msg.id}: {msg.quote}')
