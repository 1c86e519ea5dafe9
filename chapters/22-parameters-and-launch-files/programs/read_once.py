import rclpy
from rclpy.parameter import Parameter

rclpy.init()
node = rclpy.create_node("warning_light")
node.declare_parameter("color", "yellow")
color = node.get_parameter("color").value
node.set_parameters([Parameter("color", value="red")])
print(color)
print(node.get_parameter("color").value)
rclpy.shutdown()
