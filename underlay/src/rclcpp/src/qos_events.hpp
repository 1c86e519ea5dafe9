#pragma once

#include <memory>
#include <unordered_map>

#include "rcl/node.h"
#include "rcl/publisher.h"
#include "rcl/subscription.h"
#include "rclcpp/detail/entity.hpp"
#include "rclcpp/publisher_options.hpp"
#include "rclcpp/subscription_options.hpp"

namespace rclcpp::detail
{

/// One for each callback that is given. One more, unless that is handled, warns of incompatible QoS in the
/// name of `node`.
std::unordered_map<rcl_publisher_event_type_t, std::shared_ptr<Entity>> publisher_events(
  const std::shared_ptr<rcl_publisher_t> & publisher, const rcl_node_t & node,
  const PublisherOptionsBase & options);
std::unordered_map<rcl_subscription_event_type_t, std::shared_ptr<Entity>> subscription_events(
  const std::shared_ptr<rcl_subscription_t> & subscription, const rcl_node_t & node,
  const SubscriptionOptionsBase & options);

}  // namespace rclcpp::detail
