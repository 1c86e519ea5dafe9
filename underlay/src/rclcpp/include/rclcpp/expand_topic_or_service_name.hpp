#pragma once

#include <string>

namespace rclcpp
{

/// The full name, as a node of that name and namespace has it. Throws InvalidTopicNameError,
/// InvalidServiceNameError, InvalidNodeNameError, InvalidNamespaceError.
std::string expand_topic_or_service_name(
  const std::string & name, const std::string & node_name, const std::string & namespace_,
  bool is_service = false);

}  // namespace rclcpp
