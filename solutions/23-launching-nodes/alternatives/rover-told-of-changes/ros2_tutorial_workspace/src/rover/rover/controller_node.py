import rclpy
from geometry_msgs.msg import Twist
from rcl_interfaces.msg import SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rover.driving import safe_speed
from sensor_msgs.msg import Range
from std_srvs.srv import SetBool


class Controller(Node):
    """Stores the values of its parameters, and updates them in a callback."""

    def __init__(self):
        super().__init__('controller')
        self.limits = {}
        for name in ('stop_at', 'full_speed'):
            self.limits[name] = self.declare_parameter(name, 0.5).value
        self.add_on_set_parameters_callback(self.changed)
        self.stopped = False
        self.publisher = self.create_publisher(Twist, '/rover/cmd_vel', 10)
        self.subscription = self.create_subscription(
            Range, '/rover/range', self.range_callback, 10)
        self.service = self.create_service(SetBool, '/rover/stop', self.stop_callback)

    def changed(self, parameters):
        """Store the new values."""
        for parameter in parameters:
            if parameter.name in self.limits:
                self.limits[parameter.name] = parameter.value
        return SetParametersResult(successful=True)

    def range_callback(self, message):
        """Publish a speed for each measurement."""
        command = Twist()
        if not self.stopped:
            command.linear.x = safe_speed(message.range, **self.limits)
        self.publisher.publish(command)

    def stop_callback(self, request, response):
        """Stop the rover, or let it drive again."""
        self.stopped = request.data
        response.success = True
        return response


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(Controller())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
