#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>

#include "rcl/guard_condition.h"
#include "rcl/wait.h"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

/// Wakes those who wait for it; any thread may trigger it.
class GuardCondition
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(GuardCondition)

  explicit GuardCondition(
    const Context::SharedPtr & context = contexts::get_global_default_context());
  ~GuardCondition();

  void trigger();
  /// Throws RCLError, and std::runtime_error if another wait set has it.
  void add_to_wait_set(rcl_wait_set_t & wait_set);
  /// Called with the number of triggers, also for those before. An empty function ends it.
  void set_on_trigger_callback(std::function<void(std::size_t)> callback);
  /// Whether a wait set has it; the answer is as before.
  bool exchange_in_use_by_wait_set_state(bool in_use_state) {return in_use_.exchange(in_use_state);}
  rcl_guard_condition_t & get_rcl_guard_condition() {return guard_condition_;}
  const rcl_guard_condition_t & get_rcl_guard_condition() const {return guard_condition_;}

private:
  std::shared_ptr<rcl_context_t> context_;
  rcl_guard_condition_t guard_condition_;
  std::atomic_bool in_use_{false};
  std::recursive_mutex mutex_;  // for these
  rcl_wait_set_t * wait_set_ = nullptr;
  std::function<void(std::size_t)> on_trigger_;
  std::size_t unread_ = 0;
};

}  // namespace rclcpp
