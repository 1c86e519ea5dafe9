#pragma once

#include <string>
#include <vector>

#include "rcl/arguments.h"

namespace rclcpp::detail
{

/// Words after --ros-args that rcl does not know; `words` are those that were parsed.
std::vector<std::string> unknown_ros_arguments(
  const rcl_arguments_t & parsed, const std::vector<const char *> & words);

}  // namespace rclcpp::detail
