#pragma once

#include "rclcpp/executors/single_threaded_executor.hpp"

namespace rclcpp::executors
{

/// A single-threaded executor; it also notices what is added while it spins.
class StaticSingleThreadedExecutor : public SingleThreadedExecutor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(StaticSingleThreadedExecutor)
  using SingleThreadedExecutor::SingleThreadedExecutor;
};

}  // namespace rclcpp::executors
