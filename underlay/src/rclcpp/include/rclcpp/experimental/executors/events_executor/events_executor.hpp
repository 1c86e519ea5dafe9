#pragma once

#include "rclcpp/executors/single_threaded_executor.hpp"

namespace rclcpp::experimental::executors
{

/// A single-threaded executor under the name of the one that is fed by events.
class EventsExecutor : public rclcpp::executors::SingleThreadedExecutor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(EventsExecutor)
  using SingleThreadedExecutor::SingleThreadedExecutor;
};

}  // namespace rclcpp::experimental::executors
