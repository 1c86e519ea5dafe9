import rclpy
from rclpy.parameter import Parameter

rclpy.init()
node = rclpy.create_node("camera")
node.declare_parameter("exposure", 0.5)
results = node.set_parameters([Parameter("exposure", value=1)])
print(results[0].successful)
print(node.get_parameter("exposure").value)
rclpy.shutdown()
