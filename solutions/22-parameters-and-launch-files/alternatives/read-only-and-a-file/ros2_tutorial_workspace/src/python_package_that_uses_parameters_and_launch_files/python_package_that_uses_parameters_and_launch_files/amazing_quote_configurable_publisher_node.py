import sys

import rclpy
from package_with_interfaces.msg import AmazingQuote
from rcl_interfaces.msg import ParameterDescriptor, ParameterType, SetParametersResult
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node


class ConfigurablePublisher(Node):

    def __init__(self):
        super().__init__('amazing_quote_configurable_publisher_node')
        fixed = ParameterDescriptor(description='Read once, at the start', read_only=True)
        text = ParameterDescriptor(type=ParameterType.PARAMETER_STRING)
        topic = self.declare_parameter('topic_name', 'amazing_quote', fixed).value
        self.message = AmazingQuote(id=-1)
        self.message.quote = self.declare_parameter('quote', 'Use the force, Pikachu!', text).value
        self.message.philosopher_name = self.declare_parameter(
            'philosopher_name', 'Uncle Ben', text).value
        self.add_on_set_parameters_callback(self.on_change)
        self.pub = self.create_publisher(AmazingQuote, topic, 10)
        self.timer = self.create_timer(
            self.declare_parameter('period', 0.5, fixed).value, self.tick)

    def on_change(self, parameters):
        for parameter in parameters:
            if parameter.name in ('quote', 'philosopher_name'):
                setattr(self.message, parameter.name, parameter.value)
        return SetParametersResult(successful=True)

    def tick(self):
        self.message.id += 1
        self.pub.publish(self.message)


def main():
    rclpy.init(args=sys.argv)
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(ConfigurablePublisher())
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        sys.exit(130)
