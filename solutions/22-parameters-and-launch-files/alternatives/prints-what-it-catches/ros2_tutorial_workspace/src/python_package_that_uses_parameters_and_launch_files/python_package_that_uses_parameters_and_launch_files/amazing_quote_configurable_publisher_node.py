import time

import rclpy
import rclpy.node
from package_with_interfaces import msg


class Philosopher(rclpy.node.Node):
    def __init__(self):
        super().__init__('amazing_quote_configurable_publisher_node')
        print('A philosopher wakes up.')
        self.get_logger().info('Thinking about parameters.')
        time.sleep(1.0)
        self.declare_parameter(name='quote', value='Use the force, Pikachu!')
        self.declare_parameter(name='philosopher_name', value='Uncle Ben')
        self.declare_parameter(name='topic_name', value='amazing_quote')
        self.declare_parameter(name='period', value=0.5)

        topic_name: str = self.get_parameter('topic_name').get_parameter_value().string_value
        period: float = self.get_parameter('period').get_parameter_value().double_value
        self.quote_publisher = self.create_publisher(
            msg_type=msg.AmazingQuote, topic=topic_name, qos_profile=1)
        self.quote_timer = self.create_timer(timer_period_sec=period, callback=self.think)
        self.incremental_id: int = 0

    def think(self):
        thought = msg.AmazingQuote()
        thought.id = self.incremental_id
        thought.quote, thought.philosopher_name = [
            found.get_parameter_value().string_value
            for found in self.get_parameters(['quote', 'philosopher_name'])]
        self.quote_publisher.publish(thought)
        self.incremental_id += 1


def main(args=None):
    try:
        rclpy.init(args=args)
        node = Philosopher()
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    except Exception as e:
        print(e)
