#pragma once

#include <memory>
#include <vector>

#include "rcl/publisher.h"
#include "rcl/subscription.h"
#include "rclcpp/network_flow_endpoint.hpp"

namespace rclcpp::detail
{

/// Throw RCLError where the middleware cannot tell.
std::vector<NetworkFlowEndpoint> network_flows(const rcl_publisher_t & publisher);
std::vector<NetworkFlowEndpoint> network_flows(const rcl_subscription_t & subscription);

}  // namespace rclcpp::detail
