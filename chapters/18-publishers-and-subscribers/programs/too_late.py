import rclpy
from std_msgs.msg import String


def show(message):
    print(message.data)


rclpy.init()
node = rclpy.create_node("newspaper")
publisher = node.create_publisher(String, "news", 10)
publisher.publish(String(data="morning"))

node.create_subscription(String, "news", show, 10)
while publisher.get_subscription_count() == 0:
    rclpy.spin_once(node, timeout_sec=0.1)
publisher.publish(String(data="evening"))
for _ in range(10):
    rclpy.spin_once(node, timeout_sec=0.1)
rclpy.shutdown()
