#pragma once

#include "rclcpp/node_interfaces/node_clock_interface.hpp"

namespace rclcpp::node_interfaces
{

using NodeClock = NodeClockInterface;

}  // namespace rclcpp::node_interfaces
