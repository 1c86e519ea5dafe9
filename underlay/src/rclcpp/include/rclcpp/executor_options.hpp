#pragma once

#include <cstddef>

#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/memory_strategy.hpp"

namespace rclcpp
{

struct ExecutorOptions
{
  Context::SharedPtr context = contexts::get_global_default_context();
  /// Accepted, and not used.
  memory_strategy::MemoryStrategy::SharedPtr memory_strategy;
  /// Without a bound in every case.
  std::size_t max_conditions = 0;
};

}  // namespace rclcpp
