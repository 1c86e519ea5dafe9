#pragma once

#include <memory>

#include <rclcpp/rclcpp.hpp>

/// Logs periodically how many times it has logged before.
class PrintForeverNode : public rclcpp::Node
{
public:
  PrintForeverNode();

private:
  void log_();

  int times_;
  const double seconds_;
  std::shared_ptr<rclcpp::TimerBase> timer_;
};
