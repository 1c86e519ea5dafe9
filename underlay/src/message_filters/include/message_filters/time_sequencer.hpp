#pragma once

#include <chrono>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <vector>

#include "message_filters/message_traits.hpp"
#include "message_filters/simple_filter.hpp"
#include "rclcpp/rclcpp.hpp"

namespace message_filters
{

/// Passes messages on in the order of their times, each one `delay` after its time. What comes too late for that
/// is dropped.
template<class M>
class TimeSequencer : public SimpleFilter<M>
{
public:
  using typename SimpleFilter<M>::MConstPtr;
  using typename SimpleFilter<M>::EventType;

  /// It looks every `update_rate`. If there are more than `queue_size`, the oldest is dropped. A `queue_size` of 0
  /// stands for any number.
  TimeSequencer(
    rclcpp::Duration delay, rclcpp::Duration update_rate, std::uint32_t queue_size,
    rclcpp::Node::SharedPtr node)
  : delay_(delay), queue_size_(queue_size), clock_(node->get_clock())
  {
    timer_ = node->create_wall_timer(
      std::chrono::nanoseconds(update_rate.nanoseconds()), [this] {pass_on();});
  }
  template<class F>
  TimeSequencer(
    F & input, rclcpp::Duration delay, rclcpp::Duration update_rate, std::uint32_t queue_size,
    rclcpp::Node::SharedPtr node)
  : TimeSequencer(delay, update_rate, queue_size, node)
  {
    connectInput(input);
  }
  ~TimeSequencer()
  {
    timer_->cancel();
    input_.disconnect();
  }

  template<class F>
  void connectInput(F & input)
  {
    input_.disconnect();
    input_ = input.registerCallback(
      typename SimpleFilter<M>::EventCallback([this](const EventType & event) {add(event);}));
  }
  void add(const MConstPtr & message) {add(EventType(message));}
  void add(const EventType & event)
  {
    const auto time = message_traits::TimeStamp<M>::value(*event.getConstMessage()).nanoseconds();
    const std::lock_guard lock(mutex_);
    if (time < last_) {
      return;
    }
    events_.emplace(time, event);
    if (queue_size_ != 0 && events_.size() > queue_size_) {
      events_.erase(events_.begin());
    }
  }

private:
  void pass_on()
  {
    std::vector<EventType> due;
    {
      const std::lock_guard lock(mutex_);
      const auto end = events_.upper_bound((clock_->now() - delay_).nanoseconds());
      for (auto one = events_.begin(); one != end; one = events_.erase(one)) {
        last_ = one->first;
        due.push_back(one->second);
      }
    }
    for (const auto & event : due) {
      this->signalMessage(event);
    }
  }

  const rclcpp::Duration delay_;
  const std::uint32_t queue_size_;
  const rclcpp::Clock::SharedPtr clock_;
  rclcpp::TimerBase::SharedPtr timer_;
  Connection input_;

  std::mutex mutex_;
  std::multimap<std::int64_t, EventType> events_;
  std::int64_t last_ = std::numeric_limits<std::int64_t>::min();
};

}  // namespace message_filters
