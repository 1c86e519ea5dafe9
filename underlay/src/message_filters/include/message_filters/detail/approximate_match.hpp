#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace message_filters::detail
{

/// Finds messages of several topics whose times are close to each other, each message in one set at most.
///
/// A set is better than another one if its times span less. The search begins with the heads of all queues. The
/// latest of them is the pivot: any set that is found before the next one contains a message at least as late. Then
/// the oldest head is skipped again and again. The best set is always at the front of the queues, and those before
/// it are gone. It is complete as soon as no message that may still come can make a better one.
class ApproximateMatch
{
public:
  using Message = std::shared_ptr<const void>;
  /// One message of each topic.
  using Set = std::vector<Message>;

  ApproximateMatch(std::size_t topics, std::size_t queue_size);

  /// Returns the sets that are complete now. The messages of a topic come in the order of their times.
  std::vector<Set> add(std::size_t topic, std::int64_t time, Message message);

  /// Sets that span more are never made.
  std::int64_t max_span = std::numeric_limits<std::int64_t>::max();
  /// How much less a set must span for each nanosecond that it ends later.
  double age_penalty = 0.1;
  void set_lower_bound(std::size_t topic, std::int64_t bound) {topics_.at(topic).lower_bound = bound;}

private:
  struct Item
  {
    std::int64_t time;
    Message message;
  };
  struct Topic
  {
    bool has_head() const {return skipped < items.size();}
    std::int64_t head() const {return items[skipped].time;}

    std::deque<Item> items;
    /// How many of them the search has left behind.
    std::size_t skipped = 0;
    /// Messages are at least this far apart.
    std::int64_t lower_bound = 0;
    /// A better message may be lost.
    bool has_dropped = false;
    bool has_warned = false;
  };
  struct Bounds
  {
    std::int64_t start;
    std::int64_t end;
    std::size_t first;
    std::size_t last;
  };

  bool all_have_heads() const;
  template<typename TimeOf>
  Bounds bounds(const TimeOf & time_of) const;
  void search(std::vector<Set> & found);
  void make_best(const Bounds & bounds);
  /// Whether a set that ends then cannot be better than the best one if it starts then.
  bool is_worse(std::int64_t end, std::int64_t start) const;
  bool is_optimal_without_heads();
  void rewind();
  void check_order(std::size_t topic);

  const std::size_t queue_size_;
  std::vector<Topic> topics_;
  /// The best set so far, which is at the front of the queues, and the pivot.
  struct Best
  {
    std::int64_t start;
    std::int64_t end;
    std::size_t pivot;
    std::int64_t pivot_time;
  };
  std::optional<Best> best_;
};

}  // namespace message_filters::detail
