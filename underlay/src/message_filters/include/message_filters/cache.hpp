#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "message_filters/message_traits.hpp"
#include "message_filters/simple_filter.hpp"

namespace message_filters
{

/// Keeps the last messages in the order of their times, and passes each one on.
template<class M>
class Cache : public SimpleFilter<M>
{
public:
  using typename SimpleFilter<M>::MConstPtr;
  using typename SimpleFilter<M>::EventType;

  explicit Cache(unsigned int cache_size = 1) {setCacheSize(cache_size);}
  template<class F>
  explicit Cache(F & input, unsigned int cache_size = 1)
  {
    setCacheSize(cache_size);
    connectInput(input);
  }
  ~Cache() {input_.disconnect();}

  template<class F>
  void connectInput(F & input)
  {
    input_.disconnect();
    input_ = input.registerCallback(
      typename SimpleFilter<M>::EventCallback([this](const EventType & event) {add(event);}));
  }
  /// 0 changes nothing.
  void setCacheSize(unsigned int cache_size)
  {
    size_ = cache_size == 0 ? size_ : cache_size;
  }

  void add(const MConstPtr & message) {add(EventType(message));}
  void add(const EventType & event)
  {
    {
      const std::lock_guard lock(mutex_);
      while (events_.size() >= size_) {
        events_.pop_front();
      }
      events_.insert(after(time_of(event)), event);
    }
    this->signalMessage(event);
  }

  /// Messages of these times and between.
  std::vector<MConstPtr> getInterval(const rclcpp::Time & start, const rclcpp::Time & end) const
  {
    const std::lock_guard lock(mutex_);
    const auto first = from(start);
    return messages(first, std::max(first, after(end)));
  }
  /// The same, with the last message before and the first one after.
  std::vector<MConstPtr> getSurroundingInterval(const rclcpp::Time & start, const rclcpp::Time & end) const
  {
    const std::lock_guard lock(mutex_);
    if (events_.empty()) {
      return {};
    }
    auto first = after(start);
    first -= first == events_.begin() ? 0 : 1;
    auto last = std::max(first, from(end));
    last -= last == events_.end() ? 1 : 0;
    return messages(first, last + 1);
  }
  /// The last message before a time; nothing if there is none.
  MConstPtr getElemBeforeTime(const rclcpp::Time & time) const
  {
    const std::lock_guard lock(mutex_);
    const auto found = from(time);
    return found == events_.begin() ? nullptr : std::prev(found)->getConstMessage();
  }
  /// The first message after a time; nothing if there is none.
  MConstPtr getElemAfterTime(const rclcpp::Time & time) const
  {
    const std::lock_guard lock(mutex_);
    const auto found = after(time);
    return found == events_.end() ? nullptr : found->getConstMessage();
  }
  // 0 if there are no messages.
  rclcpp::Time getLatestTime() const
  {
    const std::lock_guard lock(mutex_);
    return events_.empty() ? rclcpp::Time() : time_of(events_.back());
  }
  rclcpp::Time getOldestTime() const
  {
    const std::lock_guard lock(mutex_);
    return events_.empty() ? rclcpp::Time() : time_of(events_.front());
  }

private:
  using Place = typename std::deque<EventType>::const_iterator;

  static rclcpp::Time time_of(const EventType & event)
  {
    return message_traits::TimeStamp<M>::value(*event.getConstMessage());
  }
  Place from(const rclcpp::Time & time) const
  {
    return std::find_if(
      events_.begin(), events_.end(),
      [&](const EventType & one) {return time_of(one).nanoseconds() >= time.nanoseconds();});
  }
  Place after(const rclcpp::Time & time) const
  {
    return std::find_if(
      events_.begin(), events_.end(),
      [&](const EventType & one) {return time_of(one).nanoseconds() > time.nanoseconds();});
  }
  static std::vector<MConstPtr> messages(Place begin, Place end)
  {
    std::vector<MConstPtr> found;
    std::for_each(begin, end, [&](const EventType & event) {found.push_back(event.getConstMessage());});
    return found;
  }

  mutable std::mutex mutex_;
  std::deque<EventType> events_;
  unsigned int size_ = 1;
  Connection input_;
};

}  // namespace message_filters
