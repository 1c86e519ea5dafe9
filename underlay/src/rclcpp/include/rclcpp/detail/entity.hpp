#pragma once

#include <atomic>
#include <memory>

namespace rclcpp::detail
{

/// In the order in which those that are ready at the same time get their turn.
enum class EntityKind
{
  timer,
  subscription,
  service,
  client,
  event,
  guard_condition,
  waitable,
};

/// One thing that an executor waits for: what it is to rcl, and what is done when it is ready.
class Entity
{
public:
  virtual ~Entity() = default;

  virtual EntityKind kind() const noexcept = 0;

  /// The rcl_timer_t, rcl_subscription_t, ... itself.
  virtual const void * rcl_entity() const noexcept = 0;

  /// Called before each wait: a guard condition that was found triggered is not triggered any more.
  virtual void before_wait() {}

  /// What is to be waited for beside it, in the same callback group.
  virtual std::shared_ptr<Entity> companion() {return nullptr;}

  /// Whether a wait set has it; the answer is as before.
  bool exchange_in_use_by_wait_set_state(bool in_use_state) {return in_use_.exchange(in_use_state);}

  /// Makes it nobody else's turn; false when there is nothing to do after all.
  virtual bool claim() {return true;}

  /// Takes what has come, and calls back. Nothing may have come: somebody else may have been quicker.
  virtual void execute() = 0;

private:
  std::atomic_bool in_use_{false};
};

}  // namespace rclcpp::detail
