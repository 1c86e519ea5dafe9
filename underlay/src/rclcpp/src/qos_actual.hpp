#pragma once

#include "rclcpp/exceptions.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp::detail
{

/// What rcl says of the QoS of an entity; throws when it says nothing.
inline QoS actual_qos(const rmw_qos_profile_t * qos)
{
  if (!qos) {
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "failed to get qos settings");
  }
  return QoS(QoSInitialization::from_rmw(*qos), *qos);
}

}  // namespace rclcpp::detail
