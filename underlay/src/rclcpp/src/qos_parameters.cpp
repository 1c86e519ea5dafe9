#include "rclcpp/detail/qos_parameters.hpp"

#include "rmw/qos_string_conversions.h"

namespace rclcpp::detail
{

namespace
{

[[noreturn]] void refuse(QosPolicyKind kind)
{
  throw exceptions::InvalidQosOverridesException(
          std::string("Invalid value for policy '") + qos_policy_kind_to_cstr(kind) + "'");
}

ParameterValue text(const char * name, QosPolicyKind kind)
{
  return ParameterValue(check_if_stringified_policy_is_null(name, kind));
}

template<typename Policy>
Policy known(Policy policy, Policy unknown, QosPolicyKind kind)
{
  if (policy == unknown) {
    refuse(kind);
  }
  return policy;
}

}  // namespace

const char * check_if_stringified_policy_is_null(const char * policy_value_stringified, QosPolicyKind kind)
{
  if (!policy_value_stringified) {
    throw std::invalid_argument(
            std::string("unknown value for policy kind {") + qos_policy_kind_to_cstr(kind) + "}");
  }
  return policy_value_stringified;
}

ParameterValue get_default_qos_param_value(QosPolicyKind kind, const QoS & qos)
{
  const auto & profile = qos.get_rmw_qos_profile();
  switch (kind) {
    case QosPolicyKind::AvoidRosNamespaceConventions:
      return ParameterValue(profile.avoid_ros_namespace_conventions);
    case QosPolicyKind::Deadline:
      return ParameterValue(qos.deadline().nanoseconds());
    case QosPolicyKind::Depth:
      return ParameterValue(static_cast<std::int64_t>(profile.depth));
    case QosPolicyKind::Durability:
      return text(rmw_qos_durability_policy_to_str(profile.durability), kind);
    case QosPolicyKind::History:
      return text(rmw_qos_history_policy_to_str(profile.history), kind);
    case QosPolicyKind::Lifespan:
      return ParameterValue(qos.lifespan().nanoseconds());
    case QosPolicyKind::Liveliness:
      return text(rmw_qos_liveliness_policy_to_str(profile.liveliness), kind);
    case QosPolicyKind::LivelinessLeaseDuration:
      return ParameterValue(qos.liveliness_lease_duration().nanoseconds());
    case QosPolicyKind::Reliability:
      return text(rmw_qos_reliability_policy_to_str(profile.reliability), kind);
    default:
      throw std::invalid_argument("unknown QoS policy kind");
  }
}

void apply_qos_override(QosPolicyKind kind, const ParameterValue & value, QoS & qos)
{
  const auto word = [&]() {return value.get<std::string>().c_str();};
  const auto time = [&]() {return Duration::from_nanoseconds(value.get<std::int64_t>());};
  switch (kind) {
    case QosPolicyKind::AvoidRosNamespaceConventions:
      qos.avoid_ros_namespace_conventions(value.get<bool>());
      break;
    case QosPolicyKind::Deadline:
      qos.deadline(time());
      break;
    case QosPolicyKind::Depth:
      qos.get_rmw_qos_profile().depth = static_cast<std::size_t>(value.get<std::int64_t>());
      break;
    case QosPolicyKind::Durability:
      qos.durability(
        known(rmw_qos_durability_policy_from_str(word()), RMW_QOS_POLICY_DURABILITY_UNKNOWN, kind));
      break;
    case QosPolicyKind::History:
      qos.history(
        known(rmw_qos_history_policy_from_str(word()), RMW_QOS_POLICY_HISTORY_UNKNOWN, kind));
      break;
    case QosPolicyKind::Lifespan:
      qos.lifespan(time());
      break;
    case QosPolicyKind::Liveliness:
      qos.liveliness(
        known(rmw_qos_liveliness_policy_from_str(word()), RMW_QOS_POLICY_LIVELINESS_UNKNOWN, kind));
      break;
    case QosPolicyKind::LivelinessLeaseDuration:
      qos.liveliness_lease_duration(time());
      break;
    case QosPolicyKind::Reliability:
      qos.reliability(
        known(rmw_qos_reliability_policy_from_str(word()), RMW_QOS_POLICY_RELIABILITY_UNKNOWN, kind));
      break;
    default:
      throw std::invalid_argument("unknown QoS policy kind");
  }
}

QoS overridden_qos(
  node_interfaces::NodeParametersInterface & parameters, const std::string & topic,
  const std::string & entity, const QoS & qos, const QosOverridingOptions & options)
{
  QoS result = qos;
  const std::string & id = options.get_id();
  const std::string suffix = id.empty() ? "" : "_" + id;
  const std::string of = "} for " + entity + " {" + topic + (id.empty() ? "}" : "} with id {" + id + "}");
  for (const QosPolicyKind kind : options.get_policy_kinds()) {
    if (kind == QosPolicyKind::Lifespan && entity != "publisher") {
      continue;
    }
    const std::string name =
      "qos_overrides." + topic + "." + entity + suffix + "." + qos_policy_kind_to_cstr(kind);
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.read_only = true;
    descriptor.description = std::string("qos policy {") + qos_policy_kind_to_cstr(kind) + of;
    if (parameters.has_parameter(name)) {
      apply_qos_override(kind, parameters.get_parameter(name).get_parameter_value(), result);
    } else {
      apply_qos_override(
        kind, parameters.declare_parameter(name, get_default_qos_param_value(kind, qos), descriptor), result);
    }
  }
  if (const auto & validate = options.get_validation_callback()) {
    const auto answer = validate(result);
    if (!answer.successful) {
      throw exceptions::InvalidQosOverridesException("validation callback failed: " + answer.reason);
    }
  }
  return result;
}

}  // namespace rclcpp::detail
