#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "message_filters/synchronizer.hpp"

namespace message_filters::sync_policies
{

/// Messages belong together if their times are the same.
template<typename M0, typename M1, typename ... Ms>
class ExactTime : public PolicyBase<M0, M1, Ms...>
{
  using Base = PolicyBase<M0, M1, Ms...>;

public:
  using typename Base::Events;

  /// Keeps messages of `queue_size` times that wait for others; 0 stands for any number.
  ExactTime(std::uint32_t queue_size)  // NOLINT: as the real one has it
  : queue_size_(queue_size)
  {
  }
  ExactTime(const ExactTime & other)
  : Base(other), queue_size_(other.queue_size_)
  {
  }

  template<int i>
  void add(const std::tuple_element_t<i, Events> & event)
  {
    const std::lock_guard lock(this->mutex_);
    const auto time = Base::template time_of<i>(event);
    auto & events = waiting_[time];
    std::get<i>(events) = event;
    if (std::apply([](const auto & ... each) {return (... && each.getConstMessage());}, events)) {
      const auto complete = events;
      waiting_.erase(time);
      this->call(this->signal_, complete);
      last_ = message_traits::TimeStamp<M0>::value(*std::get<0>(complete).getConstMessage());
      while (!waiting_.empty() && waiting_.begin()->first <= time) {
        drop_oldest();
      }
    }
    while (queue_size_ != 0 && waiting_.size() > queue_size_) {
      drop_oldest();
    }
  }

  /// The callback gets messages that wait in vain; pointers to those that never came are empty.
  template<typename ... Args>
  Connection registerDropCallback(Args && ... args)
  {
    return drop_signal_.addCallback(std::forward<Args>(args)...);
  }
  rclcpp::Time getLastSignalTime() const {return last_;}

private:
  void drop_oldest()
  {
    const auto oldest = waiting_.begin()->second;
    waiting_.erase(waiting_.begin());
    this->call(drop_signal_, oldest);
  }

  const std::uint32_t queue_size_;
  std::map<std::int64_t, Events> waiting_;
  rclcpp::Time last_;
  typename Base::Signal drop_signal_;
};

}  // namespace message_filters::sync_policies
