#pragma once

#include <rclcpp/rclcpp.hpp>

/// Logs, twice per second, how often it has logged before.
class PrintForeverNode : public rclcpp::Node
{
public:
  PrintForeverNode();

private:
  // TODO: a function for the timer to call, the count, and the timer itself.
};
