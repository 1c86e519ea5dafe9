#pragma once

namespace rclcpp
{

/// Of what of a subscription a wait set is to know.
class SubscriptionWaitSetMask
{
public:
  bool include_subscription = true;
  bool include_events = true;
  bool include_intra_process_waitable = true;
};

}  // namespace rclcpp
