#pragma once

#include <string>

#include "rcl/node.h"
#include "rcl/types.h"

namespace rclcpp::detail
{

/// Throws what says where the name of a topic or service goes wrong, or else what rcl said.
[[noreturn]] void throw_for_name(
  rcl_ret_t ret, const rcl_node_t & node, const char * name, bool is_service, const char * doing);

/// Throws InvalidNamespaceError unless it may be the namespace of a node.
void check_namespace(const std::string & name_space);

}  // namespace rclcpp::detail
