#pragma once

#include "rclcpp/node_interfaces/node_waitables_interface.hpp"

namespace rclcpp::node_interfaces
{

using NodeWaitables = NodeWaitablesInterface;

}  // namespace rclcpp::node_interfaces
