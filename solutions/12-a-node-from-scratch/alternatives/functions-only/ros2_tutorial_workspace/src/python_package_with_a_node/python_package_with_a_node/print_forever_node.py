import rclpy
import rclpy.executors


def make_node():
    node = rclpy.create_node('print_forever')
    count = 0

    def tick():
        nonlocal count
        node.get_logger().info('Printed %d times.' % count)
        count += 1

    node.create_timer(0.5, tick)
    return node


def run():
    rclpy.init()
    node = make_node()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, rclpy.executors.ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
