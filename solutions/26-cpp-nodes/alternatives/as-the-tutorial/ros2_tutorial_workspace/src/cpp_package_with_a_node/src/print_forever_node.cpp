#include "print_forever_node.hpp"

PrintForeverNode::PrintForeverNode()
: rclcpp::Node("print_forever_cpp"),
  seconds_(0.5),
  times_(0)
{
  timer_ = create_wall_timer(
    std::chrono::milliseconds(long(seconds_ * 1e3)), std::bind(&PrintForeverNode::log_, this));
}

void PrintForeverNode::log_()
{
  RCLCPP_INFO_STREAM(
    get_logger(), std::string("Printed ") + std::to_string(times_) + std::string(" times."));
  times_++;
}
