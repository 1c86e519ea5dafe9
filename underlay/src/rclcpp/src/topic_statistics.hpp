#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/subscription_options.hpp"
#include "rclcpp/timer.hpp"
#include "statistics_msgs/msg/metrics_message.hpp"

namespace rclcpp::detail
{

/// Average, smallest, largest and standard deviation of all values since the last reset.
class Statistics
{
public:
  void add(double value);
  void reset() {*this = Statistics();}
  statistics_msgs::msg::MetricsMessage message() const;

private:
  std::uint64_t count_ = 0;
  double average_ = 0.0, squares_ = 0.0, smallest_ = 0.0, largest_ = 0.0;
};

/// Measures how old the messages of one subscription are and how far apart they come, in ms, and publishes
/// both after each period.
class TopicStatistics
{
public:
  /// nullptr where neither the options nor the node want statistics. Throws std::invalid_argument for a
  /// period that is not positive.
  static std::shared_ptr<TopicStatistics> make(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const SubscriptionOptionsBase & options);

  TopicStatistics(
    const node_interfaces::NodeBaseInterface::SharedPtr & node,
    const SubscriptionOptionsBase::TopicStatisticsOptions & options);

  /// A message has come that was sent at `sent`, in nanoseconds of system time; 0: not known.
  void add(std::int64_t sent);

private:
  using Message = statistics_msgs::msg::MetricsMessage;

  void publish();
  Message message(const Statistics & of, const char * name, std::int64_t now) const;

  const std::string node_name_;
  std::shared_ptr<Publisher<Message>> publisher_;
  TimerBase::SharedPtr timer_;
  std::mutex mutex_;
  Statistics age_, period_;
  std::int64_t last_ = 0, window_start_;
};

}  // namespace rclcpp::detail
