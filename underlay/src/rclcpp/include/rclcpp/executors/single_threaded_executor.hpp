#pragma once

#include "rclcpp/executor.hpp"

namespace rclcpp::executors
{

/// Calls back in the thread that spins, one after the other.
class SingleThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SingleThreadedExecutor)
  using Executor::Executor;
  void spin() override;
};

}  // namespace rclcpp::executors
