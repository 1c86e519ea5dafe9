#include "rclcpp/parameter_map.hpp"

#include <memory>
#include <string_view>

#include "rcl_yaml_param_parser/parser.h"
#include "rclcpp/detail/check.hpp"

namespace rclcpp
{

namespace
{

struct FinishParams
{
  void operator()(rcl_params_t * params) const {rcl_yaml_node_struct_fini(params);}
};

template<typename T, typename Array>
ParameterValue values_of(const Array & array)
{
  return ParameterValue(std::vector<T>(array.values, array.values + array.size));
}

std::vector<std::string_view> parts_of(std::string_view name)
{
  std::vector<std::string_view> parts;
  while (!name.empty()) {
    const std::size_t slash = name.find('/');
    if (slash != 0) {
      parts.push_back(name.substr(0, slash));
    }
    name.remove_prefix(slash == std::string_view::npos ? name.size() : slash + 1);
  }
  return parts;
}

using Part = std::vector<std::string_view>::const_iterator;

bool matches(Part pattern, Part pattern_end, Part name, Part name_end)
{
  if (pattern == pattern_end) {
    return name == name_end;
  }
  if (*pattern == "**") {
    return matches(pattern + 1, pattern_end, name, name_end) ||
           (name != name_end && matches(pattern, pattern_end, name + 1, name_end));
  }
  return name != name_end && (*pattern == "*" || *pattern == *name) &&
         matches(pattern + 1, pattern_end, name + 1, name_end);
}

/// Whether `pattern`, a node's name as parameter files write it, means the node: `/**`, `/*/talker`.
bool is_meant(const std::string & pattern, const std::string & name)
{
  const auto patterns = parts_of(pattern), names = parts_of(name);
  return matches(patterns.begin(), patterns.end(), names.begin(), names.end());
}

std::vector<Parameter> parameters_of(const rcl_node_params_t & node, std::size_t index)
{
  std::vector<Parameter> parameters;
  for (std::size_t i = 0; i < node.num_params; ++i) {
    if (!node.parameter_names[i]) {
      throw exceptions::InvalidParametersException(
              "At node " + std::to_string(index) + " parameter " + std::to_string(i) + " name is NULL");
    }
    parameters.emplace_back(node.parameter_names[i], parameter_value_from(&node.parameter_values[i]));
  }
  return parameters;
}

void check_params(const rcl_params_t * params)
{
  if (!params) {
    throw exceptions::InvalidParametersException("parameters struct is NULL");
  }
  if (!params->node_names) {
    throw exceptions::InvalidParametersException("node names array is NULL");
  }
  if (!params->params) {
    throw exceptions::InvalidParametersException("node params array is NULL");
  }
}

}  // namespace

ParameterMap parameter_map_from(const rcl_params_t * c_params, const char * node_fqn)
{
  check_params(c_params);
  ParameterMap found;
  for (std::size_t i = 0; i < c_params->num_nodes; ++i) {
    if (!c_params->node_names[i]) {
      throw exceptions::InvalidParametersException("Node name at index " + std::to_string(i) + " is NULL");
    }
    std::string name = c_params->node_names[i];
    name = name.empty() || name.front() != '/' ? "/" + name : name;
    if (node_fqn && !is_meant(name, node_fqn)) {
      continue;
    }
    auto & parameters = found[node_fqn ? node_fqn : name];
    const auto more = parameters_of(c_params->params[i], i);
    parameters.insert(parameters.end(), more.begin(), more.end());
  }
  return found;
}

ParameterValue parameter_value_from(const rcl_variant_t * c_value)
{
  if (!c_value) {
    throw exceptions::InvalidParameterValueException("Passed argument is NULL");
  }
  if (c_value->bool_value) {
    return ParameterValue(*c_value->bool_value);
  }
  if (c_value->integer_value) {
    return ParameterValue(*c_value->integer_value);
  }
  if (c_value->double_value) {
    return ParameterValue(*c_value->double_value);
  }
  if (c_value->string_value) {
    return ParameterValue(c_value->string_value);
  }
  if (c_value->byte_array_value) {
    return values_of<std::uint8_t>(*c_value->byte_array_value);
  }
  if (c_value->bool_array_value) {
    return values_of<bool>(*c_value->bool_array_value);
  }
  if (c_value->integer_array_value) {
    return values_of<std::int64_t>(*c_value->integer_array_value);
  }
  if (c_value->double_array_value) {
    return values_of<double>(*c_value->double_array_value);
  }
  if (c_value->string_array_value) {
    const auto & words = *c_value->string_array_value;
    return ParameterValue(std::vector<std::string>(words.data, words.data + words.size));
  }
  throw exceptions::InvalidParameterValueException("No parameter value set");
}

ParameterMap parameter_map_from_yaml_file(const std::string & yaml_filename, const char * node_fqn)
{
  const std::unique_ptr<rcl_params_t, FinishParams> params(
    rcl_yaml_node_struct_init(rcl_get_default_allocator()));
  if (!rcl_parse_yaml_file(yaml_filename.c_str(), params.get())) {
    exceptions::throw_from_rcl_error(RCL_RET_ERROR);
  }
  return parameter_map_from(params.get(), node_fqn);
}

std::vector<Parameter> parameters_from_map(const ParameterMap & parameter_map, const char * node_fqn)
{
  std::vector<Parameter> all;
  for (const auto & [name, parameters] : parameter_map) {
    if (!node_fqn || is_meant(name, node_fqn)) {
      all.insert(all.end(), parameters.begin(), parameters.end());
    }
  }
  return all;
}

}  // namespace rclcpp
