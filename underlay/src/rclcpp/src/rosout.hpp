#pragma once

#include "rcl/node.h"

namespace rclcpp::detail
{

// What is logged under the name of a node goes to /rosout through one publisher: rcl keeps one for each name.
// Of living nodes of the same name it is the oldest one's; when that goes, the next one's takes its place.
// All of these are called with logging_mutex() held.

/// Throws RCLError.
void begin_rosout(rcl_node_t & node);

/// Does nothing for a node that has not begun, or whose /rosout was forgotten.
void end_rosout(rcl_node_t & node) noexcept;

/// For all nodes: rcl's logging, and with it each /rosout, is about to end.
void forget_rosout();

}  // namespace rclcpp::detail
