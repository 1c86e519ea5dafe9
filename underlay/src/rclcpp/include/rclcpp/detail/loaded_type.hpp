#pragma once

#include <string>

#include "rosidl_runtime_c/message_type_support_struct.h"

namespace rclcpp::detail
{

/// The type of a name like std_msgs/msg/String; its library stays loaded, as the middleware remembers types.
/// Throws std::runtime_error when there is none.
const rosidl_message_type_support_t & load_type(const std::string & name);

}  // namespace rclcpp::detail
