#pragma once

#include <map>
#include <string>
#include <vector>

#include "rcl/arguments.h"
#include "rclcpp/parameter.hpp"

namespace rclcpp::detail
{

/// The values that command line and files give to parameters of the node `name`; later `sources` win.
std::map<std::string, ParameterValue> parameter_overrides(
  const std::string & name, const std::vector<const rcl_arguments_t *> & sources);

}  // namespace rclcpp::detail
