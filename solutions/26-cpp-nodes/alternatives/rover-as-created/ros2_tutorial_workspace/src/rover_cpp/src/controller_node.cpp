#include <functional>
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/range.hpp"

using geometry_msgs::msg::Twist;
using sensor_msgs::msg::Range;

static void drive(const rclcpp::Publisher<Twist>::SharedPtr & publisher, const Range::SharedPtr measured)
{
  auto command = std::make_unique<Twist>();
  if (measured->range >= 1.0F) {
    command->linear.x = 0.5;
  } else if (measured->range > 0.5F) {
    command->linear.x = measured->range - 0.5F;
  }
  publisher->publish(std::move(command));
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("controller");
  auto publisher = node->create_publisher<Twist>("/rover/cmd_vel", rclcpp::QoS(10));
  auto subscription = node->create_subscription<Range>(
    "/rover/range", rclcpp::SensorDataQoS(), std::bind(drive, publisher, std::placeholders::_1));
  rclcpp::executors::MultiThreadedExecutor executor;
  executor.add_node(node);
  executor.spin();
  rclcpp::shutdown();
}
