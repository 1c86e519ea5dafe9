import rclpy
import rclpy.node
from package_with_interfaces import msg


class Student(rclpy.node.Node):
    def __init__(self):
        super().__init__('amazing_quote_subscriber_node')
        self.notes = self.create_subscription(
            msg.AmazingQuote, 'amazing_quote', self.listen, qos_profile=10)

    def listen(self, heard: msg.AmazingQuote):
        self.get_logger().info(f"""heard:
  no. {heard.id}
  "{heard.quote}"
    {heard.philosopher_name}
""")


def main(args=None):
    try:
        rclpy.init(args=args)
        node = Student()
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    except Exception as e:
        print(e)
