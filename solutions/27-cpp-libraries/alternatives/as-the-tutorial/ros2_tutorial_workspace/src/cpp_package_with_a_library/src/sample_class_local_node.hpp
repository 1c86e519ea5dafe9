#pragma once

#include <cpp_package_with_a_library/sample_class.hpp>
#include <rclcpp/rclcpp.hpp>

/// Logs a different sum twice per second, and the same object.
class SampleClassLocalNode : public rclcpp::Node
{
public:
  SampleClassLocalNode();

private:
  void log_both_();

  int round_ = 0;
  SampleClass sample_;
  rclcpp::TimerBase::SharedPtr timer_;
};
