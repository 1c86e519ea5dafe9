#pragma once

#include <chrono>

#include "cpp_package_with_a_library/sample_class.hpp"
#include <rclcpp/rclcpp.hpp>

class SampleClassLocalNode : public rclcpp::Node
{
public:
    SampleClassLocalNode();

private:
    static constexpr std::chrono::duration<double> every_{0.5};

    void tell_();

    rclcpp::TimerBase::SharedPtr timer_;
    SampleClass sample_;
};
