#pragma once

#include <memory>

#include <rclcpp/rclcpp.hpp>

/// Logs periodically how many times it has logged before.
class PrintForeverNode : public rclcpp::Node
{
private:
  double seconds_;
  int times_;
  std::shared_ptr<rclcpp::TimerBase> timer_;

  void log_();

public:
  PrintForeverNode();
};
