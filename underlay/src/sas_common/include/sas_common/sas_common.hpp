// Parameters that a program cannot do without, and a word at its end.

#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <rclcpp/rclcpp.hpp>

namespace sas
{

namespace detail
{

template<typename T>
inline constexpr bool is_list = false;
template<typename T>
inline constexpr bool is_list<std::vector<T>> = true;

inline bool says_empty_list(const rclcpp::ParameterValue & value)
{
  return value.get_type() == rclcpp::ParameterType::PARAMETER_STRING_ARRAY &&
         value.get<std::vector<std::string>>() == std::vector<std::string>{"EMPTY_LIST"};
}

/// Whether a list is to be declared, and it is set to an empty one.
template<typename T>
bool is_empty_list(rclcpp::Node & node, const std::string & name)
{
  const auto & overrides = node.get_node_parameters_interface()->get_parameter_overrides();
  const auto found = overrides.find(name);
  return is_list<T> && found != overrides.end() && says_empty_list(found->second);
}

}  // namespace detail

/// Declare the parameter and put its value into `value`.
///
/// The list ["EMPTY_LIST"] stands for an empty one of any type: a parameter file cannot say of which type an
/// empty list is. Throws std::runtime_error, which names the parameter, when it was not set or has another type.
template<typename T>
void get_ros_parameter(
  const std::shared_ptr<rclcpp::Node> & node, const std::string & parameter_name, T & value)
{
  try {
    if (!node->has_parameter(parameter_name)) {
      if (detail::is_empty_list<T>(*node, parameter_name)) {
        node->declare_parameter<std::vector<std::string>>(parameter_name);
      } else {
        node->declare_parameter<T>(parameter_name);
      }
    }
    if constexpr (detail::is_list<T>) {
      if (detail::says_empty_list(node->get_parameter(parameter_name).get_parameter_value())) {
        value = T();
        return;
      }
    }
    value = node->get_parameter(parameter_name).template get_value<T>();
  } catch (const std::exception & error) {
    throw std::runtime_error(
      "The parameter " + parameter_name + " of the node " + node->get_name() +
      " must be set, with a value of its type: " + error.what());
  }
}

/// The same; `value` becomes `default_value` when the parameter was not set.
template<typename T>
void get_ros_optional_parameter(
  const std::shared_ptr<rclcpp::Node> & node, const std::string & parameter_name, T & value,
  const std::decay_t<T> & default_value)
{
  if (!node->has_parameter(parameter_name)) {
    node->declare_parameter<T>(parameter_name, default_value);
  }
  get_ros_parameter(node, parameter_name, value);
}

/// For the end of a `main` that started ROS without signal handlers: what ROS may say after that is not an error.
inline void display_signal_handler_none_bug_info(const std::shared_ptr<rclcpp::Node> & node)
{
  RCLCPP_INFO(
    node->get_logger(), "ROS was started without signal handlers: complaints after this line do no harm.");
}

}  // namespace sas
