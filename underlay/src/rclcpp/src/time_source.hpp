#pragma once

#include <memory>

#include "rclcpp/clock.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_options.hpp"

namespace rclcpp::detail
{

/// Lets `clock` follow the messages on /clock while the parameter use_sim_time is true; declares it.
/// Ends with what it gives back.
std::shared_ptr<void> follow_sim_time(
  const node_interfaces::NodeBaseInterface::SharedPtr & node,
  const node_interfaces::NodeParametersInterface::SharedPtr & parameters, const Clock::SharedPtr & clock,
  const NodeOptions & options);

}  // namespace rclcpp::detail
