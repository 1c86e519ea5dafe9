#pragma once

#include <memory>
#include <vector>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp::detail
{

/// The six services through which others read and set the parameters of the node.
std::vector<ServiceBase::SharedPtr> parameter_services(
  const node_interfaces::NodeBaseInterface::SharedPtr & node,
  const node_interfaces::NodeParametersInterface::SharedPtr & parameters);

}  // namespace rclcpp::detail
