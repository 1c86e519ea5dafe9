#pragma once

#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp::node_interfaces
{

using NodeBase = NodeBaseInterface;

}  // namespace rclcpp::node_interfaces
