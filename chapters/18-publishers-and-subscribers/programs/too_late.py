import rclpy
from std_msgs.msg import String


def show(message):
    print(message.data)


rclpy.init()
node = rclpy.create_node("horn")
publisher = node.create_publisher(String, "rover/horn", 10)
publisher.publish(String(data="beep"))

node.create_subscription(String, "rover/horn", show, 10)
while publisher.get_subscription_count() == 0:
    rclpy.spin_once(node, timeout_sec=0.1)
publisher.publish(String(data="honk"))
for _ in range(10):
    rclpy.spin_once(node, timeout_sec=0.1)
rclpy.shutdown()
