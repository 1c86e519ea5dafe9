#include "print_forever_node.hpp"

using namespace std::chrono_literals;

PrintForeverNode::PrintForeverNode()
: rclcpp::Node("print_forever")
{
  timer_ = this->create_wall_timer(0.5s, [this]() {timer_callback_();});
}

void PrintForeverNode::timer_callback_()
{
  RCLCPP_INFO(this->get_logger(), "Printed %d times.", count_++);
}
