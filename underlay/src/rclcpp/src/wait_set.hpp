#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <vector>

#include "rcl/wait.h"
#include "rclcpp/context.hpp"
#include "rclcpp/detail/entity.hpp"
#include "rclcpp/guard_condition.hpp"

namespace rclcpp::detail
{

/// Adds what a waitable consists of. Otherwise `index` becomes the entity's place among those of its kind.
rcl_ret_t add_to_wait_set(rcl_wait_set_t & set, const Entity & entity, std::size_t & index);

/// How many of each kind a wait set has room for.
struct WaitSetRoom
{
  std::size_t subscriptions = 0, guard_conditions = 0, timers = 0, clients = 0, services = 0, events = 0;

  void add(const Entity & entity);
  bool fits(const rcl_wait_set_t & set) const;
  rcl_ret_t resize(rcl_wait_set_t & set) const;
};

/// rcl's wait set. All of it is for one thread at a time.
class WaitSet
{
public:
  explicit WaitSet(const Context::SharedPtr & context);
  WaitSet(const WaitSet &) = delete;
  WaitSet & operator=(const WaitSet &) = delete;
  ~WaitSet();

  /// Waits until one of `entities` is ready or `interrupt` is triggered; a negative timeout is for ever.
  /// Whether anything was.
  bool wait(
    const std::vector<std::shared_ptr<Entity>> & entities, const GuardCondition & interrupt,
    std::chrono::nanoseconds timeout);

  /// Whether the entity with this index was ready at the last wait; it must still be there.
  bool is_ready(std::size_t index) const;

private:
  void fill(const std::vector<std::shared_ptr<Entity>> & entities, const GuardCondition & interrupt);
  void make_room(const std::vector<std::shared_ptr<Entity>> & entities);

  struct Place
  {
    const Entity * entity;
    std::size_t index;
  };

  std::shared_ptr<rcl_context_t> context_;
  rcl_wait_set_t set_ = rcl_get_zero_initialized_wait_set();
  std::vector<Place> places_;
};

}  // namespace rclcpp::detail
