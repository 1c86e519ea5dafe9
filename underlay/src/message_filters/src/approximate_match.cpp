#include "message_filters/detail/approximate_match.hpp"

#include <algorithm>
#include <utility>

#include "rcutils/logging_macros.h"

namespace message_filters::detail
{

ApproximateMatch::ApproximateMatch(std::size_t topics, std::size_t queue_size)
: queue_size_(queue_size), topics_(topics)
{
}

std::vector<ApproximateMatch::Set> ApproximateMatch::add(
  std::size_t topic, std::int64_t time, Message message)
{
  std::vector<Set> found;
  auto & changed = topics_.at(topic);
  const bool had_head = changed.has_head();
  changed.items.push_back({time, std::move(message)});
  check_order(topic);
  if (!had_head) {
    search(found);
  }
  if (changed.items.size() > queue_size_) {
    rewind();
    changed.items.pop_front();
    changed.has_dropped = true;
    if (best_) {  // one of its messages is gone
      best_.reset();
      search(found);
    }
  }
  return found;
}

void ApproximateMatch::search(std::vector<Set> & found)
{
  while (all_have_heads()) {
    const auto now = bounds([](const Topic & topic) {return topic.head();});
    for (std::size_t i = 0; i < topics_.size(); ++i) {
      topics_[i].has_dropped = topics_[i].has_dropped && i == now.last;
    }
    if (!best_) {
      if (now.end - now.start > max_span || topics_[now.last].has_dropped) {
        topics_[now.first].items.pop_front();
        continue;
      }
      best_ = Best{0, 0, now.last, now.end};
      make_best(now);
    } else if (!is_worse(now.end, now.start)) {
      make_best(now);
    }
    ++topics_[now.first].skipped;
    const bool is_optimal = now.first == best_->pivot || is_worse(now.end, best_->pivot_time);
    if (is_optimal || (!all_have_heads() && is_optimal_without_heads())) {
      Set set;
      rewind();
      for (auto & topic : topics_) {
        set.push_back(std::move(topic.items.front().message));
        topic.items.pop_front();
      }
      best_.reset();
      found.push_back(std::move(set));
    }
  }
}

/// Whether the best set remains the best one even if missing messages come as early as they can.
bool ApproximateMatch::is_optimal_without_heads()
{
  std::vector<std::size_t> before;
  for (const auto & topic : topics_) {
    before.push_back(topic.skipped);
  }
  const auto earliest = [this](const Topic & topic) {
      return topic.has_head() ? topic.head() :
             std::max(topic.items.back().time + topic.lower_bound, best_->pivot_time);
    };
  while (true) {
    const auto then = bounds(earliest);
    if (is_worse(then.end, best_->pivot_time)) {
      return true;
    }
    if (!is_worse(then.end, then.start)) {
      for (std::size_t i = 0; i < topics_.size(); ++i) {
        topics_[i].skipped = before[i];
      }
      return false;
    }
    ++topics_[then.first].skipped;
  }
}

void ApproximateMatch::make_best(const Bounds & bounds)
{
  best_->start = bounds.start;
  best_->end = bounds.end;
  for (auto & topic : topics_) {
    topic.items.erase(topic.items.begin(), topic.items.begin() + static_cast<std::ptrdiff_t>(topic.skipped));
    topic.skipped = 0;
  }
}

bool ApproximateMatch::is_worse(std::int64_t end, std::int64_t start) const
{
  const auto later = static_cast<long double>(end - best_->end) * (1 + age_penalty);
  return static_cast<std::int64_t>(later) >= start - best_->start;
}

bool ApproximateMatch::all_have_heads() const
{
  return std::all_of(topics_.begin(), topics_.end(), [](const Topic & topic) {return topic.has_head();});
}

/// The earliest and the latest time. Of several, the first is the earliest one, and the last the latest one.
template<typename TimeOf>
ApproximateMatch::Bounds ApproximateMatch::bounds(const TimeOf & time_of) const
{
  const auto time = time_of(topics_.front());
  Bounds found{time, time, 0, 0};
  for (std::size_t i = 1; i < topics_.size(); ++i) {
    const auto other = time_of(topics_[i]);
    if (other < found.start) {
      found.start = other;
      found.first = i;
    }
    if (other >= found.end) {
      found.end = other;
      found.last = i;
    }
  }
  return found;
}

void ApproximateMatch::rewind()
{
  for (auto & topic : topics_) {
    topic.skipped = 0;
  }
}

void ApproximateMatch::check_order(std::size_t number)
{
  auto & topic = topics_[number];
  const auto count = topic.items.size();
  if (topic.has_warned || count < 2) {
    return;
  }
  const auto gap = topic.items[count - 1].time - topic.items[count - 2].time;
  if (gap < topic.lower_bound) {
    topic.has_warned = true;
    RCUTILS_LOG_WARN_NAMED(
      "message_filters", "The times of messages of input %zu are closer than they should be, or go back; this "
      "is said only once", number);
  }
}

}  // namespace message_filters::detail
