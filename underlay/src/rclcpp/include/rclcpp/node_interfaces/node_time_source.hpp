#pragma once

#include "rclcpp/node_interfaces/node_time_source_interface.hpp"

namespace rclcpp::node_interfaces
{

using NodeTimeSource = NodeTimeSourceInterface;

}  // namespace rclcpp::node_interfaces
