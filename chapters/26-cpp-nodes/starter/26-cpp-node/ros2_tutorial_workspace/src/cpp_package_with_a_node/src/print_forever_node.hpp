#pragma once

#include <rclcpp/rclcpp.hpp>

/// Logs twice per second how many times it has logged before.
class PrintForeverNode : public rclcpp::Node
{
public:
  PrintForeverNode();

private:
  // TODO: the function that the timer calls, the count, and the timer.
};
