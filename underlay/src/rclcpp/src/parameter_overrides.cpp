#include "parameter_overrides.hpp"

#include <memory>
#include <string_view>

#include "rcl_yaml_param_parser/parser.h"
#include "rclcpp/detail/check.hpp"

namespace rclcpp::detail
{

namespace
{

struct Finish
{
  void operator()(rcl_params_t * params) const {rcl_yaml_node_struct_fini(params);}
};

template<typename T, typename Array>
std::vector<T> vector_of(const Array & array)
{
  return std::vector<T>(array.values, array.values + array.size);
}

ParameterValue value_of(const rcl_variant_t & variant)
{
  if (variant.bool_value) {
    return ParameterValue(*variant.bool_value);
  }
  if (variant.integer_value) {
    return ParameterValue(*variant.integer_value);
  }
  if (variant.double_value) {
    return ParameterValue(*variant.double_value);
  }
  if (variant.string_value) {
    return ParameterValue(variant.string_value);
  }
  if (variant.byte_array_value) {
    return ParameterValue(vector_of<std::uint8_t>(*variant.byte_array_value));
  }
  if (variant.bool_array_value) {
    return ParameterValue(vector_of<bool>(*variant.bool_array_value));
  }
  if (variant.integer_array_value) {
    return ParameterValue(vector_of<std::int64_t>(*variant.integer_array_value));
  }
  if (variant.double_array_value) {
    return ParameterValue(vector_of<double>(*variant.double_array_value));
  }
  if (variant.string_array_value) {
    const auto & words = *variant.string_array_value;
    return ParameterValue(std::vector<std::string>(words.data, words.data + words.size));
  }
  return ParameterValue();
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

}  // namespace

bool is_meant(const std::string & pattern, const std::string & name)
{
  const auto patterns = parts_of(pattern), names = parts_of(name);
  return matches(patterns.begin(), patterns.end(), names.begin(), names.end());
}

std::map<std::string, ParameterValue> parameter_overrides(
  const std::string & name, const std::vector<const rcl_arguments_t *> & sources)
{
  std::map<std::string, ParameterValue> overrides;
  for (const rcl_arguments_t * source : sources) {
    rcl_params_t * found = nullptr;
    check(rcl_arguments_get_param_overrides(source, &found), "failed to get parameter overrides");
    const std::unique_ptr<rcl_params_t, Finish> params(found);
    for (std::size_t node = 0; params && node < params->num_nodes; ++node) {
      if (!is_meant(params->node_names[node], name)) {
        continue;
      }
      const rcl_node_params_t & own = params->params[node];
      for (std::size_t i = 0; i < own.num_params; ++i) {
        overrides[own.parameter_names[i]] = value_of(own.parameter_values[i]);
      }
    }
  }
  return overrides;
}

}  // namespace rclcpp::detail
