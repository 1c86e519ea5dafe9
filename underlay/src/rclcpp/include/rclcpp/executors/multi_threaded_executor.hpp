#pragma once

#include <chrono>
#include <cstddef>

#include "rclcpp/executor.hpp"

namespace rclcpp::executors
{

/// Calls back in several threads; of a mutually exclusive group one callback at a time. What a callback
/// throws, in whichever thread, ends them all and is thrown by spin(): the first of it, if there is more.
class MultiThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MultiThreadedExecutor)

  /// As many threads as there are cores, and at least two, unless a number is given.
  explicit MultiThreadedExecutor(
    const ExecutorOptions & options = ExecutorOptions(), std::size_t number_of_threads = 0,
    bool yield_before_execute = false,
    std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));

  void spin() override;
  std::size_t get_number_of_threads() {return number_of_threads_;}

private:
  void run();

  std::size_t number_of_threads_;
  bool yield_before_execute_;
  std::chrono::nanoseconds timeout_;
};

}  // namespace rclcpp::executors
