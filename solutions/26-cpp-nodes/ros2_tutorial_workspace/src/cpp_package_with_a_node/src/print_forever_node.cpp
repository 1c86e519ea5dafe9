#include "print_forever_node.hpp"

#include <chrono>
#include <functional>

using namespace std::chrono_literals;

PrintForeverNode::PrintForeverNode()
: rclcpp::Node("print_forever")
{
  timer_ = create_wall_timer(500ms, std::bind(&PrintForeverNode::timer_callback_, this));
}

void PrintForeverNode::timer_callback_()
{
  RCLCPP_INFO_STREAM(get_logger(), "Printed " << count_ << " times.");
  count_++;
}
