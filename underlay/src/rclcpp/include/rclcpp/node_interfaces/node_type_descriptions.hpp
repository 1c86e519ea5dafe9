#pragma once

#include "rclcpp/node_interfaces/node_type_descriptions_interface.hpp"

namespace rclcpp::node_interfaces
{

using NodeTypeDescriptions = NodeTypeDescriptionsInterface;

}  // namespace rclcpp::node_interfaces
