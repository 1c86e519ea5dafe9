import sys
import time

import rclpy
import rclpy.node
from rclpy.executors import ExternalShutdownException


class Node(rclpy.node.Node):
    said = []

    def say(self):
        self.get_logger().info('Printed ' + str(len(self.said)) + ' times.')
        self.said.append(True)


def main():
    rclpy.init(args=sys.argv)
    node = Node('print_forever')
    print('Printing the node first,')
    for word in ('Getting', 'ready', 'slowly'):
        node.get_logger().info(f'{word}.')
    time.sleep(1.5)
    node.create_timer(0.5, lambda: node.say())
    try:
        while rclpy.ok():
            rclpy.spin_once(node, timeout_sec=0.1)
    except (KeyboardInterrupt, ExternalShutdownException):
        sys.exit(1)
    finally:
        node.destroy_node()
