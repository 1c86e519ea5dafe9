#pragma once

#include "rcl/allocator.h"

namespace rclcpp::detail
{

/// Frees what rcl has allocated with its default allocator.
struct Deallocate
{
  void operator()(void * memory) const
  {
    const rcl_allocator_t allocator = rcl_get_default_allocator();
    allocator.deallocate(memory, allocator.state);
  }
};

}  // namespace rclcpp::detail
