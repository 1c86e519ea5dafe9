#pragma once

#include <memory>
#include <vector>

#include "rclcpp/executor.hpp"
#include "wait_set.hpp"

namespace rclcpp
{

struct Executor::Waiting
{
  struct Found
  {
    std::weak_ptr<detail::Entity> entity;
    CallbackGroup::WeakPtr group;
    detail::EntityKind kind;
  };

  explicit Waiting(const Context::SharedPtr & context) : set(context) {}

  detail::WaitSet set;
  // What was ready at the last wait and had no turn yet, the next one last.
  std::vector<Found> found;
  std::vector<std::shared_ptr<detail::Entity>> entities;
  std::vector<CallbackGroup::SharedPtr> groups;
};

}  // namespace rclcpp
