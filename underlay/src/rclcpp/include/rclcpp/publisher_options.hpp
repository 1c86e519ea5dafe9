#pragma once

#include <memory>

#include "rcl/publisher.h"
#include "rclcpp/callback_group.hpp"
#include "rclcpp/event_handler.hpp"
#include "rclcpp/intra_process_setting.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/qos_overriding_options.hpp"
#include "rmw/types.h"

namespace rclcpp
{

struct PublisherOptionsBase
{
  /// Messages are handed over within the process where both ends want it.
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  PublisherEventCallbacks event_callbacks;
  /// Whether incompatible subscriptions are warned of where no callback is given for that.
  bool use_default_callbacks = true;
  /// Whether its packets must be told from those of others by address and port.
  rmw_unique_network_flow_endpoints_requirement_t require_unique_network_flow_endpoints =
    RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_NOT_REQUIRED;
  CallbackGroup::SharedPtr callback_group;
  QosOverridingOptions qos_overriding_options;
};

template<typename AllocatorT>
struct PublisherOptionsWithAllocator : PublisherOptionsBase
{
  std::shared_ptr<AllocatorT> allocator;

  PublisherOptionsWithAllocator() = default;
  explicit PublisherOptionsWithAllocator(const PublisherOptionsBase & base) : PublisherOptionsBase(base) {}

  /// What of it rcl takes.
  template<typename MessageT>
  rcl_publisher_options_t to_rcl_publisher_options(const QoS & qos) const
  {
    rcl_publisher_options_t options = rcl_publisher_get_default_options();
    options.qos = qos.get_rmw_qos_profile();
    options.rmw_publisher_options.require_unique_network_flow_endpoints = require_unique_network_flow_endpoints;
    return options;
  }
};

using PublisherOptions = PublisherOptionsWithAllocator<std::allocator<void>>;

}  // namespace rclcpp
