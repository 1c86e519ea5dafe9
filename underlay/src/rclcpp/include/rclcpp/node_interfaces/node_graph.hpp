#pragma once

#include "rclcpp/node_interfaces/node_graph_interface.hpp"

namespace rclcpp::node_interfaces
{

using NodeGraph = NodeGraphInterface;

}  // namespace rclcpp::node_interfaces
