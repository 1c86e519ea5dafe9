#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "rcl_yaml_param_parser/types.h"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/parameter_value.hpp"

namespace rclcpp
{

/// The parameters of each node, by the node's full name. Names may have wildcards, as in parameter files.
using ParameterMap = std::unordered_map<std::string, std::vector<Parameter>>;

/// With `node_fqn`, only what is meant for this node, all by its name.
/// Throws InvalidParametersException for what is not there, InvalidParameterValueException for no value.
ParameterMap parameter_map_from(const rcl_params_t * c_params, const char * node_fqn = nullptr);

/// Throws InvalidParameterValueException if there is no value.
ParameterValue parameter_value_from(const rcl_variant_t * c_value);

/// Throws RCLError if the file is not there or not a file of parameters.
ParameterMap parameter_map_from_yaml_file(
  const std::string & yaml_filename, const char * node_fqn = nullptr);

/// All parameters, or those that are meant for the node `node_fqn`.
std::vector<Parameter> parameters_from_map(
  const ParameterMap & parameter_map, const char * node_fqn = nullptr);

}  // namespace rclcpp
