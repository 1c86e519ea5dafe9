#include "sample_class_local_node.hpp"

#include <functional>

SampleClassLocalNode::SampleClassLocalNode() : Node("sample_class_local_node")
{
    sample_.set_a_private_member(7);
    timer_ = this->create_timer(every_, std::bind(&SampleClassLocalNode::tell_, this));
}

void SampleClassLocalNode::tell_()
{
    const auto sum = std::to_string(sample_.sum_of_squares(2., 3.));
    RCLCPP_INFO_STREAM(this->get_logger(), "Sum of squares: " + sum);
    RCLCPP_INFO_STREAM(this->get_logger(), sample_);
}
