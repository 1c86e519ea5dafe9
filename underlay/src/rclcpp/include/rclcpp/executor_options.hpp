#pragma once

#include <cstddef>

#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"

namespace rclcpp
{

struct ExecutorOptions
{
  Context::SharedPtr context = contexts::get_global_default_context();
  /// Without a bound in every case.
  std::size_t max_conditions = 0;
};

}  // namespace rclcpp
