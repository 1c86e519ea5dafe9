import rclpy
import rclpy.node
import rclpy.qos
from package_with_interfaces import msg


class Philosopher(rclpy.node.Node):
    def __init__(self):
        super().__init__('amazing_quote_publisher_node')
        self._last_id = -1
        qos = rclpy.qos.QoSProfile(
            depth=10, durability=rclpy.qos.DurabilityPolicy.TRANSIENT_LOCAL)
        self.quote_publisher = self.create_publisher(msg.AmazingQuote, 'amazing_quote', qos)
        self.quote_timer = self.create_timer(0.5, self.think)

    @property
    def new_id(self):
        self._last_id += 1
        return self._last_id

    def think(self):
        thought = msg.AmazingQuote()
        thought.id = self.new_id
        thought.quote = 'Thinking is a timer that fires by itself.'
        thought.philosopher_name = 'The watchmaker'
        self.quote_publisher.publish(thought)


def main(args=None):
    try:
        rclpy.init(args=args)
        node = Philosopher()
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    except Exception as e:
        print(e)
