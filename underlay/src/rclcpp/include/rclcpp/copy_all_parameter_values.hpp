#pragma once

#include <string>

#include "rclcpp/logging.hpp"
#include "rclcpp/node_interfaces/getters.hpp"

namespace rclcpp
{

/// Declares the parameters of `source` at `destination`. With `override_existing_params`, it sets those that
/// are there already, and logs a warning for what cannot be set.
template<typename SourceT, typename DestinationT>
void copy_all_parameter_values(
  const SourceT & source, const DestinationT & destination, const bool override_existing_params = false)
{
  const auto from = source->get_node_parameters_interface();
  const auto to = destination->get_node_parameters_interface();
  const auto warn = [&](const Parameter & parameter, const std::string & reason) {
      RCLCPP_WARN(
        destination->get_node_logging_interface()->get_logger(), "Unable to set parameter (%s): %s!",
        parameter.get_name().c_str(), reason.c_str());
    };
  for (const auto & name : from->list_parameters({}, 0).names) {
    const Parameter parameter = from->get_parameter(name);
    if (!to->has_parameter(name)) {
      to->declare_parameter(
        name, parameter.get_parameter_value(), from->describe_parameters({name}).front());
    } else if (override_existing_params) {
      try {
        const auto result = to->set_parameters_atomically({parameter});
        if (!result.successful) {
          warn(parameter, result.reason);
        }
      } catch (const exceptions::InvalidParameterTypeException & error) {
        warn(parameter, error.what());
      }
    }
  }
}

}  // namespace rclcpp
