#include "sample_class_local_node.hpp"

#include <chrono>
#include <functional>

SampleClassLocalNode::SampleClassLocalNode():
    rclcpp::Node("sample_class_local_node"),
    timer_period_(0.5)
{
    sample_.set_a_private_member(7);
    timer_ = this->create_timer(
        std::chrono::duration<double>(timer_period_),
        std::bind(&SampleClassLocalNode::_timer_callback, this));
}

void SampleClassLocalNode::_timer_callback()
{
    RCLCPP_INFO_STREAM(
        this->get_logger(),
        std::string("Sum of squares: ") + std::to_string(sample_.sum_of_squares(2., 3.)));
    RCLCPP_INFO_STREAM(this->get_logger(), sample_);
}
