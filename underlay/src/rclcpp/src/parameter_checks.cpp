#include "parameter_checks.hpp"

#include <cmath>
#include <limits>

namespace rclcpp::detail
{

namespace
{

using rcl_interfaces::msg::ParameterDescriptor;
using Result = rcl_interfaces::msg::SetParametersResult;

Result refused(const std::string & reason)
{
  Result result;
  result.successful = false;
  result.reason = reason;
  return result;
}

Result allowed()
{
  Result result;
  result.successful = true;
  return result;
}

Result out_of_range(const std::string & name, const char * kind)
{
  return refused("Parameter {" + name + "} doesn't comply with " + kind + " range.");
}

bool are_equal(double left, double right)
{
  const double unit = std::numeric_limits<double>::epsilon() * 100;
  return std::abs(left - right) <= unit * std::abs(left + right) || std::abs(left - right) < unit;
}

bool is_in_range(double value, const rcl_interfaces::msg::FloatingPointRange & range)
{
  if (are_equal(value, range.from_value) || are_equal(value, range.to_value)) {
    return true;
  }
  if (value < range.from_value || value > range.to_value || std::isnan(value)) {
    return false;
  }
  if (range.step == 0.0) {
    return true;
  }
  const double steps = std::round((value - range.from_value) / range.step);
  return are_equal(value, range.from_value + steps * range.step);
}

bool is_in_range(std::int64_t value, const rcl_interfaces::msg::IntegerRange & range)
{
  if (value == range.from_value || value == range.to_value) {
    return true;
  }
  if (value < range.from_value || value > range.to_value) {
    return false;
  }
  const auto distance =
    static_cast<std::uint64_t>(value) - static_cast<std::uint64_t>(range.from_value);
  return range.step == 0 || distance % range.step == 0;
}

}  // namespace

const char * const wrong_type = "Wrong parameter type";

Result check_parameter(const Parameter & parameter, const ParameterDescriptor & descriptor)
{
  const std::string & name = parameter.get_name();
  if (!descriptor.dynamic_typing && descriptor.type != parameter.get_type()) {
    return refused(
      std::string(wrong_type) + ", parameter {" + name + "} is of type {" +
      to_string(static_cast<ParameterType>(descriptor.type)) + "}, setting it to {" +
      parameter.get_type_name() + "} is not allowed.");
  }
  if (!descriptor.integer_range.empty() && parameter.get_type() == PARAMETER_INTEGER &&
    !is_in_range(parameter.as_int(), descriptor.integer_range.front()))
  {
    return out_of_range(name, "integer");
  }
  if (!descriptor.floating_point_range.empty() && parameter.get_type() == PARAMETER_DOUBLE &&
    !is_in_range(parameter.as_double(), descriptor.floating_point_range.front()))
  {
    return out_of_range(name, "floating point");
  }
  return allowed();
}

}  // namespace rclcpp::detail
