#include "topic_statistics.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "rclcpp/time.hpp"
#include "statistics_msgs/msg/statistic_data_type.hpp"

namespace rclcpp::detail
{

namespace
{

constexpr double nanoseconds_per_ms = 1e6;

/// Nanoseconds of system time.
std::int64_t system_now()
{
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

}  // namespace

void Statistics::add(double value)
{
  smallest_ = count_ ? std::min(smallest_, value) : value;
  largest_ = count_ ? std::max(largest_, value) : value;
  ++count_;
  const double before = value - average_;
  average_ += before / static_cast<double>(count_);
  squares_ += before * (value - average_);
}

statistics_msgs::msg::MetricsMessage Statistics::message() const
{
  using Type = statistics_msgs::msg::StatisticDataType;
  const double count = static_cast<double>(count_);
  const auto known = [&](double value) {
      return count_ ? value : std::numeric_limits<double>::quiet_NaN();
    };
  statistics_msgs::msg::MetricsMessage message;
  const auto put = [&](std::uint8_t type, double value) {
      message.statistics.emplace_back();
      message.statistics.back().data_type = type;
      message.statistics.back().data = value;
    };
  put(Type::STATISTICS_DATA_TYPE_AVERAGE, known(average_));
  put(Type::STATISTICS_DATA_TYPE_MAXIMUM, known(largest_));
  put(Type::STATISTICS_DATA_TYPE_MINIMUM, known(smallest_));
  put(Type::STATISTICS_DATA_TYPE_SAMPLE_COUNT, count);
  put(Type::STATISTICS_DATA_TYPE_STDDEV, known(std::sqrt(squares_ / count)));
  return message;
}

std::shared_ptr<TopicStatistics> TopicStatistics::make(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const SubscriptionOptionsBase & options)
{
  if (!resolve_enable_topic_statistics(options, *node)) {
    return nullptr;
  }
  const auto period = options.topic_stats_options.publish_period;
  if (period <= std::chrono::milliseconds(0)) {
    throw std::invalid_argument(
            "topic_stats_options.publish_period must be greater than 0, specified value of " +
            std::to_string(period.count()) + " ms");
  }
  const auto made = std::make_shared<TopicStatistics>(node, options.topic_stats_options);
  made->timer_ = std::make_shared<WallTimer<>>(
    period, [weak = std::weak_ptr<TopicStatistics>(made)](TimerBase &) {
      if (const auto statistics = weak.lock()) {
        statistics->publish();
      }
    }, node->get_context());
  node->add(made->timer_, options.callback_group);
  return made;
}

TopicStatistics::TopicStatistics(
  const node_interfaces::NodeBaseInterface::SharedPtr & node,
  const SubscriptionOptionsBase::TopicStatisticsOptions & options)
: node_name_(node->get_name()),
  publisher_(
    std::make_shared<Publisher<Message>>(node, options.publish_topic, options.qos, PublisherOptions())),
  window_start_(system_now())
{
}

void TopicStatistics::add(std::int64_t sent)
{
  const std::int64_t now = system_now();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (sent) {
    age_.add(static_cast<double>(now - sent) / nanoseconds_per_ms);
  }
  if (last_) {
    period_.add(static_cast<double>(now - last_) / nanoseconds_per_ms);
  }
  last_ = now;
}

void TopicStatistics::publish()
{
  std::vector<Message> messages;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::int64_t now = system_now();
    messages = {message(age_, "message_age", now), message(period_, "message_period", now)};
    age_.reset();
    period_.reset();
    window_start_ = now;
  }
  for (const auto & message : messages) {
    publisher_->publish(message);
  }
}

TopicStatistics::Message TopicStatistics::message(
  const Statistics & of, const char * name, std::int64_t now) const
{
  Message message = of.message();
  message.measurement_source_name = node_name_;
  message.metrics_source = name;
  message.unit = "ms";
  message.window_start = Time(window_start_);
  message.window_stop = Time(now);
  return message;
}

}  // namespace rclcpp::detail
