#pragma once

#include <rclcpp/rclcpp.hpp>

/// Logs twice per second how many times it has logged before.
class PrintForeverNode : public rclcpp::Node
{
public:
  PrintForeverNode();

private:
  void timer_callback_();

  int count_ = 0;
  rclcpp::TimerBase::SharedPtr timer_;
};
