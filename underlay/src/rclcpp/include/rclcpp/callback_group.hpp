#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "rclcpp/detail/entity.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

enum class CallbackGroupType
{
  MutuallyExclusive,
  Reentrant,
};

/// Callbacks of which a multi-threaded executor runs one at a time, or any number at once.
class CallbackGroup
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(CallbackGroup)

  explicit CallbackGroup(
    CallbackGroupType group_type, bool automatically_add_to_executor_with_node = true);
  CallbackGroup(
    CallbackGroupType group_type, std::weak_ptr<Context> context,
    bool automatically_add_to_executor_with_node = true);

  CallbackGroupType type() const {return type_;}
  bool automatically_add_to_executor_with_node() const {return automatic_;}

  /// Whether an executor has it; set by the executor alone.
  std::atomic_bool & get_associated_with_executor_atomic() {return associated_;}

  /// False while one of its callbacks runs, if they exclude each other.
  std::atomic_bool & can_be_taken_from() {return can_be_taken_from_;}

  std::size_t size() const;

  /// What is still there of what was added, in order.
  void collect(std::vector<std::shared_ptr<detail::Entity>> & found);
  /// Adds it, and wakes the executor to which this group was added by itself.
  void add(const std::shared_ptr<detail::Entity> & entity);

  void remove(const std::shared_ptr<detail::Entity> & entity);

  /// Triggered when something is added. Null without a context, and after its end.
  std::shared_ptr<GuardCondition> get_notify_guard_condition();

  /// Whom to wake when something is added.
  void set_waker(const std::shared_ptr<GuardCondition> & waker);

private:
  const CallbackGroupType type_;
  const bool automatic_;
  const std::weak_ptr<Context> context_;
  std::atomic_bool associated_{false};
  std::atomic_bool can_be_taken_from_{true};
  mutable std::mutex mutex_;
  std::vector<std::weak_ptr<detail::Entity>> entities_;
  std::weak_ptr<GuardCondition> waker_;
  std::shared_ptr<GuardCondition> notify_;
};

}  // namespace rclcpp
