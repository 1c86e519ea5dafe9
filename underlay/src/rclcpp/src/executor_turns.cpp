#include <algorithm>
#include <utility>

#include "executor_waiting.hpp"

namespace rclcpp
{

namespace
{

/// The turn of a group: while it lasts, callbacks that exclude each other find it taken.
class Turn
{
public:
  explicit Turn(CallbackGroup & group) : group_(group) {}
  Turn(const Turn &) = delete;
  Turn & operator=(const Turn &) = delete;
  ~Turn()
  {
    if (group_.type() == CallbackGroupType::MutuallyExclusive) {
      group_.can_be_taken_from() = true;
    }
  }

private:
  CallbackGroup & group_;
};

bool take_turn(CallbackGroup & group)
{
  return group.type() == CallbackGroupType::Reentrant || group.can_be_taken_from().exchange(false);
}

}  // namespace

void Executor::wait(std::chrono::nanoseconds timeout)
{
  auto & [set, found, entities, groups] = *waiting_;
  found.clear();
  entities.clear();  // as the last wait has done, unless it failed
  groups.clear();
  for (const auto & known : get_all_callback_groups()) {
    const auto group = known.lock();
    if (group && group->can_be_taken_from()) {
      group->collect(entities);
      groups.resize(entities.size(), group);
    }
  }
  const bool any = set.wait(entities, *interrupt_, timeout);
  for (std::size_t i = entities.size(); any && i-- > 0; ) {
    if (set.is_ready(i)) {
      found.push_back({entities[i], groups[i], entities[i]->kind()});
    }
  }
  std::stable_sort(
    found.begin(), found.end(), [](const auto & a, const auto & b) {return a.kind > b.kind;});
  entities.clear();
  groups.clear();
}

Executor::Ready Executor::pick()
{
  auto & found = waiting_->found;
  while (!found.empty()) {
    Ready ready{found.back().entity.lock(), found.back().group.lock()};
    found.pop_back();
    // What is left out because its group is taken will be found ready once more.
    if (!ready.entity || !ready.group || !take_turn(*ready.group)) {
      continue;
    }
    if (ready.entity->claim()) {
      return ready;
    }
    const Turn given_back(*ready.group);
  }
  return {};
}

Executor::Ready Executor::next(std::chrono::nanoseconds timeout)
{
  const std::lock_guard lock(wait_mutex_);
  auto ready = pick();
  if (!ready && goes_on()) {
    wait(timeout);
    ready = pick();
  }
  return ready;
}

void Executor::execute(Ready ready)
{
  {
    const Turn turn(*ready.group);
    ready.entity->execute();
  }
  if (is_shared_ && ready.group->type() == CallbackGroupType::MutuallyExclusive) {
    interrupt_->trigger();
  }
}

void Executor::spin_ready(std::chrono::nanoseconds max_duration, bool again)
{
  const Spinning spinning(*this, again ? "spin_all" : "spin_some");
  const auto began = std::chrono::steady_clock::now();
  const auto goes_on_in_time = [&]() {
      const bool bounded = max_duration > std::chrono::nanoseconds(0);
      return goes_on() && !(bounded && std::chrono::steady_clock::now() - began >= max_duration);
    };
  bool any = true;
  for (bool first = true; goes_on_in_time() && any && (first || again); first = false) {
    any = false;
    {
      const std::lock_guard lock(wait_mutex_);
      wait(std::chrono::nanoseconds(0));
    }
    while (goes_on_in_time()) {
      std::unique_lock lock(wait_mutex_);
      auto ready = pick();
      lock.unlock();
      if (!ready) {
        break;
      }
      execute(std::move(ready));
      any = true;
    }
  }
}

}  // namespace rclcpp
