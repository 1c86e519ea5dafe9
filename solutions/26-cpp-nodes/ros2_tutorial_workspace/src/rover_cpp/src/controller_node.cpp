#include <algorithm>
#include <memory>

#include <geometry_msgs/msg/twist.hpp>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/range.hpp>

/// Drives the rover toward the wall and stops in front of it.
class Controller : public rclcpp::Node
{
public:
  Controller()
  : rclcpp::Node("controller")
  {
    publisher_ = create_publisher<geometry_msgs::msg::Twist>("/rover/cmd_vel", 10);
    subscription_ = create_subscription<sensor_msgs::msg::Range>(
      "/rover/range", 10,
      [this](const sensor_msgs::msg::Range & measured) { range_callback_(measured); });
  }

private:
  void range_callback_(const sensor_msgs::msg::Range & measured)
  {
    geometry_msgs::msg::Twist command;
    command.linear.x = std::clamp(measured.range - 0.5, 0.0, 0.5);
    publisher_->publish(command);
  }

  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr publisher_;
  rclcpp::Subscription<sensor_msgs::msg::Range>::SharedPtr subscription_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Controller>());
  rclcpp::shutdown();
  return 0;
}
