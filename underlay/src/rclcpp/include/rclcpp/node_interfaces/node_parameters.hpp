#pragma once

#include "rclcpp/node_interfaces/node_parameters_interface.hpp"

namespace rclcpp::node_interfaces
{

using NodeParameters = NodeParametersInterface;

}  // namespace rclcpp::node_interfaces
