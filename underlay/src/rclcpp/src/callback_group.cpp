#include "rclcpp/callback_group.hpp"

#include <algorithm>

namespace rclcpp
{

CallbackGroup::CallbackGroup(CallbackGroupType group_type, bool automatically_add_to_executor_with_node)
: type_(group_type), automatic_(automatically_add_to_executor_with_node)
{
}

std::size_t CallbackGroup::size() const
{
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(
           entities_.begin(), entities_.end(), [](const auto & known) {return !known.expired();}));
}

void CallbackGroup::collect(std::vector<std::shared_ptr<detail::Entity>> & found)
{
  const std::lock_guard lock(mutex_);
  bool gone = false;
  for (const auto & known : entities_) {
    if (auto entity = known.lock()) {
      found.push_back(std::move(entity));
    } else {
      gone = true;
    }
  }
  if (gone) {
    entities_.erase(
      std::remove_if(
        entities_.begin(), entities_.end(), [](const auto & known) {return known.expired();}),
      entities_.end());
  }
}

void CallbackGroup::add(const std::shared_ptr<detail::Entity> & entity)
{
  std::unique_lock lock(mutex_);
  entities_.push_back(entity);
  const auto waker = waker_.lock();
  lock.unlock();
  if (waker) {
    waker->trigger();
  }
}

void CallbackGroup::remove(const std::shared_ptr<detail::Entity> & entity)
{
  const std::lock_guard lock(mutex_);
  entities_.erase(
    std::remove_if(
      entities_.begin(), entities_.end(), [&](const auto & known) {return known.lock() == entity;}),
    entities_.end());
}

void CallbackGroup::set_waker(const std::shared_ptr<GuardCondition> & waker)
{
  const std::lock_guard lock(mutex_);
  waker_ = waker;
}

}  // namespace rclcpp
