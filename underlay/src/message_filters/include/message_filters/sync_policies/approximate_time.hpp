#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>

#include "message_filters/detail/approximate_match.hpp"
#include "message_filters/synchronizer.hpp"
#include "rclcpp/duration.hpp"

namespace message_filters::sync_policies
{

/// Messages belong together if their times are close to each other; each one is used once at most.
template<typename M0, typename M1, typename ... Ms>
class ApproximateTime : public PolicyBase<M0, M1, Ms...>
{
  using Base = PolicyBase<M0, M1, Ms...>;

public:
  using typename Base::Events;

  /// Keeps `queue_size` messages of each kind that wait for others: better 2 or more.
  ApproximateTime(std::uint32_t queue_size)  // NOLINT: as the real one has it
  : match_(std::tuple_size_v<Events>, queue_size)
  {
  }
  ApproximateTime(const ApproximateTime & other)
  : Base(other), match_(other.match_)
  {
  }

  template<int i>
  void add(const std::tuple_element_t<i, Events> & event)
  {
    using Event = std::tuple_element_t<i, Events>;
    const std::lock_guard lock(this->mutex_);
    const auto found = match_.add(i, Base::template time_of<i>(event), std::make_shared<const Event>(event));
    for (const auto & set : found) {
      this->call(this->signal_, events_of(set, std::make_index_sequence<std::tuple_size_v<Events>>()));
    }
  }

  /// 0.1 at first: to be better, a set that ends later must span less by more than a tenth of that time.
  void setAgePenalty(double age_penalty) {match_.age_penalty = age_penalty;}
  /// Messages of an input are never closer to each other than this, so sets are complete earlier.
  void setInterMessageLowerBound(int i, rclcpp::Duration lower_bound)
  {
    match_.set_lower_bound(static_cast<std::size_t>(i), lower_bound.nanoseconds());
  }
  /// Messages that are farther apart never belong together.
  void setMaxIntervalDuration(rclcpp::Duration max_interval_duration)
  {
    match_.max_span = max_interval_duration.nanoseconds();
  }

private:
  template<std::size_t ... is>
  static Events events_of(const detail::ApproximateMatch::Set & set, std::index_sequence<is...>)
  {
    return Events(*std::static_pointer_cast<const std::tuple_element_t<is, Events>>(set[is])...);
  }

  detail::ApproximateMatch match_;
};

}  // namespace message_filters::sync_policies
