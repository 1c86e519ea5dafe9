#pragma once

#include "rclcpp/node_interfaces/node_services_interface.hpp"

namespace rclcpp::node_interfaces
{

using NodeServices = NodeServicesInterface;

}  // namespace rclcpp::node_interfaces
