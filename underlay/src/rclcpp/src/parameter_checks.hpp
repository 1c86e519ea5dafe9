#pragma once

#include "rcl_interfaces/msg/detail/parameter_descriptor__struct.hpp"
#include "rcl_interfaces/msg/detail/set_parameters_result__struct.hpp"
#include "rclcpp/parameter.hpp"

namespace rclcpp::detail
{

/// What the reason of a refusal begins with when it is the type.
extern const char * const wrong_type;

/// Whether the type and the range that `descriptor` demands allow the value.
rcl_interfaces::msg::SetParametersResult check_parameter(
  const Parameter & parameter, const rcl_interfaces::msg::ParameterDescriptor & descriptor);

}  // namespace rclcpp::detail
