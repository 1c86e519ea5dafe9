#pragma once

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
};

/// One thing that an executor waits for: what it is to rcl, and what is done when it is ready.
class Entity
{
public:
  virtual ~Entity() = default;

  virtual EntityKind kind() const noexcept = 0;

  /// The rcl_timer_t, rcl_subscription_t, ... itself.
  virtual const void * rcl_entity() const noexcept = 0;

  /// Makes it nobody else's turn; false when there is nothing to do after all.
  virtual bool claim() {return true;}

  /// Takes what has come, and calls back. Nothing may have come: somebody else may have been quicker.
  virtual void execute() = 0;
};

}  // namespace rclcpp::detail
