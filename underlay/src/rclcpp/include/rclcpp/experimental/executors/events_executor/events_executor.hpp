#pragma once

#include <chrono>
#include <stdexcept>

#include "rclcpp/executors/single_threaded_executor.hpp"

namespace rclcpp::experimental::executors
{

/// A single-threaded executor under the name of the one that is fed by events.
class EventsExecutor : public rclcpp::executors::SingleThreadedExecutor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(EventsExecutor)
  using SingleThreadedExecutor::SingleThreadedExecutor;

  /// Throws std::invalid_argument unless the time is positive.
  void spin_all(std::chrono::nanoseconds max_duration) override
  {
    if (max_duration <= std::chrono::nanoseconds(0)) {
      throw std::invalid_argument("max_duration must be positive");
    }
    SingleThreadedExecutor::spin_all(max_duration);
  }
};

}  // namespace rclcpp::experimental::executors
