#pragma once

#include <vector>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp::detail
{

/// The two services through which others read and set the levels of the program's loggers.
std::vector<ServiceBase::SharedPtr> logger_services(
  const node_interfaces::NodeBaseInterface::SharedPtr & node);

}  // namespace rclcpp::detail
