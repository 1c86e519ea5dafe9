#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "rcl/node.h"
#include "rclcpp/context.hpp"

namespace rclcpp::detail
{

/// Waits until `holds`, looking whenever nodes, topics or services come or go; a negative timeout is for
/// ever. Whether it holds; the end of the context ends the waiting.
bool wait_for_graph(
  const std::shared_ptr<rcl_node_t> & node, const Context::SharedPtr & context,
  const std::function<bool()> & holds, std::chrono::nanoseconds timeout);

}  // namespace rclcpp::detail
