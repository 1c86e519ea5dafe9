#pragma once

#include <memory>
#include <vector>

#include "rcl/publisher.h"
#include "rcl/subscription.h"
#include "rclcpp/detail/entity.hpp"
#include "rclcpp/publisher_options.hpp"
#include "rclcpp/subscription_options.hpp"

namespace rclcpp::detail
{

/// One for each callback that is given, and one that warns of incompatible QoS unless that is handled.
std::vector<std::shared_ptr<Entity>> publisher_events(
  const std::shared_ptr<rcl_publisher_t> & publisher, const PublisherOptionsBase & options);
std::vector<std::shared_ptr<Entity>> subscription_events(
  const std::shared_ptr<rcl_subscription_t> & subscription, const SubscriptionOptionsBase & options);

}  // namespace rclcpp::detail
