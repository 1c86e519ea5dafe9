#include "rclcpp/qos_overriding_options.hpp"

#include "rmw/qos_string_conversions.h"

namespace rclcpp
{

const char * qos_policy_kind_to_cstr(const QosPolicyKind & qos_policy)
{
  const char * name = rmw_qos_policy_kind_to_str(static_cast<rmw_qos_policy_kind_t>(qos_policy));
  if (!name) {
    throw std::invalid_argument("unknown QoS policy kind");
  }
  return name;
}

QosOverridingOptions::QosOverridingOptions(
  std::initializer_list<QosPolicyKind> policy_kinds, QosCallback validation_callback, std::string id)
: id_(std::move(id)), policy_kinds_(policy_kinds), validation_callback_(std::move(validation_callback))
{
}

QosOverridingOptions QosOverridingOptions::with_default_policies(
  QosCallback validation_callback, std::string id)
{
  return QosOverridingOptions(
    {QosPolicyKind::History, QosPolicyKind::Depth, QosPolicyKind::Reliability},
    std::move(validation_callback), std::move(id));
}

}  // namespace rclcpp
