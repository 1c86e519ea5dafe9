#pragma once

#include <memory>
#include <mutex>

namespace rclcpp::detail
{

/// Guards rcl's logging, which knows no threads: configuring, printing, and the /rosout of each node.
std::shared_ptr<std::recursive_mutex> logging_mutex();

}  // namespace rclcpp::detail
