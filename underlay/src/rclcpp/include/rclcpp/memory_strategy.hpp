#pragma once

#include "rcl/allocator.h"
#include "rclcpp/macros.hpp"

namespace rclcpp::memory_strategy
{

/// Where the memory of an executor is to come from. Executors take one, but allocate by themselves.
class MemoryStrategy
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(MemoryStrategy)
  virtual ~MemoryStrategy() = default;

  virtual rcl_allocator_t get_allocator() = 0;
};

}  // namespace rclcpp::memory_strategy
