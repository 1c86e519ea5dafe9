#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>

#include "rclcpp/wait_result_kind.hpp"
#include "rclcpp/wait_set_base.hpp"

namespace rclcpp
{

/// What came of waiting, and what was ready. It is about the last wait of its wait set alone.
template<class WaitSetT>
class WaitResult final
{
public:
  WaitResult(WaitResultKind kind, WaitSetT & wait_set)
  : kind_(kind), wait_set_(&wait_set), state_(wait_set.state()) {}
  WaitResult(WaitResult &&) noexcept = default;
  WaitResult(const WaitResult &) = delete;
  WaitResult & operator=(const WaitResult &) = delete;

  WaitResultKind kind() const
  {
    const bool is_out_of_date = kind_ == WaitResultKind::Ready && state_ != wait_set_->state();
    return is_out_of_date ? WaitResultKind::Invalid : kind_;
  }

  /// Throws std::runtime_error unless something is ready.
  const WaitSetT & get_wait_set() const {return *ready();}
  WaitSetT & get_wait_set() {return *ready();}

  /// The first timer that is ready, from an index on, and its index. It stays ready until it is cleared.
  std::pair<std::shared_ptr<TimerBase>, std::size_t> peek_next_ready_timer(std::size_t start_index = 0)
  {
    std::size_t i = start_index;
    for (; is_valid() && i < wait_set_->size_of_timers(); ++i) {
      if (wait_set_->get_rcl_wait_set().timers[i]) {
        return {wait_set_->timers(i), i};
      }
    }
    return {nullptr, i};
  }
  /// Throws std::out_of_range.
  void clear_timer_with_index(std::size_t index)
  {
    if (index >= wait_set_->size_of_timers()) {
      throw std::out_of_range("given timer index is out of range");
    }
    wait_set_->changeable_rcl_wait_set().timers[index] = nullptr;
  }

  // One after the other; nothing when there is no other one.
  std::shared_ptr<SubscriptionBase> next_ready_subscription()
  {
    const auto found = next(&rcl_wait_set_t::subscriptions, wait_set_->size_of_subscriptions());
    return found.first ? wait_set_->subscriptions(found.second) : nullptr;
  }
  std::shared_ptr<ServiceBase> next_ready_service()
  {
    const auto found = next(&rcl_wait_set_t::services, wait_set_->size_of_services());
    return found.first ? wait_set_->services(found.second) : nullptr;
  }
  std::shared_ptr<ClientBase> next_ready_client()
  {
    const auto found = next(&rcl_wait_set_t::clients, wait_set_->size_of_clients());
    return found.first ? wait_set_->clients(found.second) : nullptr;
  }

private:
  bool is_valid() const {return kind() == WaitResultKind::Ready;}

  WaitSetT * ready() const
  {
    if (kind_ != WaitResultKind::Ready) {
      throw std::runtime_error("cannot access wait set when the result was not ready");
    }
    return wait_set_;
  }

  /// Whether one is ready, and which; it is not from now on.
  template<typename ArrayT>
  std::pair<bool, std::size_t> next(ArrayT rcl_wait_set_t::* array, std::size_t size)
  {
    for (std::size_t i = 0; is_valid() && i < size; ++i) {
      auto & entity = (wait_set_->changeable_rcl_wait_set().*array)[i];
      if (entity) {
        entity = nullptr;
        return {true, i};
      }
    }
    return {false, size};
  }

  WaitResultKind kind_;
  WaitSetT * wait_set_;
  std::size_t state_;
};

}  // namespace rclcpp
