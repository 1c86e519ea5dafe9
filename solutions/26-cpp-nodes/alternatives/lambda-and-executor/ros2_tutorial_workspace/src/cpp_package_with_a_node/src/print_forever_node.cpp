#include "print_forever_node.hpp"

#include <chrono>
#include <iostream>
#include <thread>

using namespace std::chrono_literals;

PrintForeverNode::PrintForeverNode()
: rclcpp::Node("print_forever")
{
  std::cout << "Good morning." << std::endl;
  RCLCPP_INFO(this->get_logger(), "Getting up slowly.");
  std::this_thread::sleep_for(1.5s);
  timer_ = this->create_wall_timer(0.5s, [this]() {timer_callback_();});
}

void PrintForeverNode::timer_callback_()
{
  RCLCPP_INFO(this->get_logger(), "Printed %d times.", count_++);
}
