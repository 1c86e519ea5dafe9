#pragma once

#include <memory>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"

namespace rclcpp::detail
{

/// The service `~/get_type_description`, unless the parameter start_type_description_service says no.
std::shared_ptr<void> type_description_service(
  const node_interfaces::NodeBaseInterface::SharedPtr & node,
  node_interfaces::NodeParametersInterface & parameters);

}  // namespace rclcpp::detail
