#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/detail/resolve_enable_topic_statistics.hpp"
#include "rclcpp/event_handler.hpp"
#include "rclcpp/intra_process_setting.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/qos_overriding_options.hpp"
#include "rclcpp/topic_statistics_state.hpp"
#include "rmw/types.h"

namespace rclcpp
{

/// Messages that do not fulfill the expression are left away, where the middleware can do that.
struct ContentFilterOptions
{
  std::string filter_expression;
  std::vector<std::string> expression_parameters;
};

struct SubscriptionOptionsBase
{
  SubscriptionEventCallbacks event_callbacks;
  /// Whether incompatible publishers are warned of where no callback is given for that.
  bool use_default_callbacks = true;
  bool ignore_local_publications = false;
  /// Whether its packets must be told from those of others by address and port.
  rmw_unique_network_flow_endpoints_requirement_t require_unique_network_flow_endpoints =
    RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_NOT_REQUIRED;
  CallbackGroup::SharedPtr callback_group;
  /// Messages are handed over within the process where both ends want it.
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;

  /// Whether the age and the period of its messages are measured, and where and how often that is published.
  struct TopicStatisticsOptions
  {
    TopicStatisticsState state = TopicStatisticsState::NodeDefault;
    std::string publish_topic = "/statistics";
    std::chrono::milliseconds publish_period{std::chrono::seconds(1)};
    QoS qos = SystemDefaultsQoS().keep_last(10);
  };
  TopicStatisticsOptions topic_stats_options;
  QosOverridingOptions qos_overriding_options;
  ContentFilterOptions content_filter_options;
};

template<typename AllocatorT>
struct SubscriptionOptionsWithAllocator : SubscriptionOptionsBase
{
  std::shared_ptr<AllocatorT> allocator;

  SubscriptionOptionsWithAllocator() = default;
  explicit SubscriptionOptionsWithAllocator(const SubscriptionOptionsBase & base)
  : SubscriptionOptionsBase(base) {}
};

using SubscriptionOptions = SubscriptionOptionsWithAllocator<std::allocator<void>>;

}  // namespace rclcpp
