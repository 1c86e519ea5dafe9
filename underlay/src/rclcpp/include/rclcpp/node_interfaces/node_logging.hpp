#pragma once

#include "rclcpp/node_interfaces/node_logging_interface.hpp"

namespace rclcpp::node_interfaces
{

using NodeLogging = NodeLoggingInterface;

}  // namespace rclcpp::node_interfaces
