#include "print_forever_node.hpp"

PrintForeverNode::PrintForeverNode()
: rclcpp::Node("print_forever_cpp"), times_(0), seconds_(0.5)
{
  const auto period = std::chrono::milliseconds(static_cast<long>(1000 * seconds_));
  timer_ = create_wall_timer(period, std::bind(&PrintForeverNode::log_, this));
}

void PrintForeverNode::log_()
{
  const std::string count = std::to_string(times_++);
  RCLCPP_INFO_STREAM(get_logger(), "Printed " + count + std::string(" times."));
}
