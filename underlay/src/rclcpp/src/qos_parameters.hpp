#pragma once

#include <string>

#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/qos_overriding_options.hpp"

namespace rclcpp::detail
{

/// `qos` as the parameters `qos_overrides.<topic>.<entity>.<policy>` have it; declares them.
/// Throws InvalidQosOverridesException for values that say nothing, or that the node refuses.
QoS overridden_qos(
  node_interfaces::NodeParametersInterface & parameters, const std::string & topic,
  const std::string & entity, const QoS & qos, const QosOverridingOptions & options);

}  // namespace rclcpp::detail
