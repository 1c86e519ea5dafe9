#pragma once

#include "rclcpp/node_interfaces/node_timers_interface.hpp"

namespace rclcpp::node_interfaces
{

using NodeTimers = NodeTimersInterface;

}  // namespace rclcpp::node_interfaces
