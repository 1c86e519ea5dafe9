#include "sample_class_local_node.hpp"

SampleClassLocalNode::SampleClassLocalNode()
: rclcpp::Node("sample_class_local_node")
{
  for (int line = 0; line < 8; ++line) {
    RCLCPP_INFO_STREAM(get_logger(), "I assume that a summary comes.");
  }
  timer_ = create_wall_timer(
    std::chrono::milliseconds(500), std::bind(&SampleClassLocalNode::log_both_, this));
}

void SampleClassLocalNode::log_both_()
{
  const double sum = SampleClass::sum_of_squares(round_, round_ - 5);
  RCLCPP_INFO_STREAM(get_logger(), "sum_of_squares = " + std::to_string(sum));
  RCLCPP_INFO_STREAM(get_logger(), sample_.to_string() + std::to_string(round_) + " times.");
  round_++;
}
