#pragma once

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/node_interfaces/getters.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/qos_overriding_options.hpp"

namespace rclcpp::detail
{

template<typename NodeT, typename = void>
struct has_parameters : std::disjunction<
    node_interfaces::has_node_parameters_interface<NodeT>,
    std::is_convertible<NodeT &, node_interfaces::NodeParametersInterface::SharedPtr>> {};
template<typename NodeT>
struct has_parameters<
  NodeT, std::void_t<decltype(std::declval<NodeT &>()->get_node_parameters_interface())>>
  : std::true_type {};

struct PublisherQosParametersTraits
{
  static constexpr const char * entity_type() {return "publisher";}
};

struct SubscriptionQosParametersTraits
{
  static constexpr const char * entity_type() {return "subscription";}
};

/// `qos` as the parameters `qos_overrides.<topic>.<entity>.<policy>` have it; declares them. A subscription
/// has no lifespan. Throws InvalidQosOverridesException for values that say nothing, or that the node refuses.
QoS overridden_qos(
  node_interfaces::NodeParametersInterface & parameters, const std::string & topic,
  const std::string & entity, const QoS & qos, const QosOverridingOptions & options);

/// Throws std::invalid_argument for a null pointer, which stands for a policy without a name.
const char * check_if_stringified_policy_is_null(const char * policy_value_stringified, QosPolicyKind kind);

// What a policy is as a parameter, and back. Both throw std::invalid_argument for what is not a policy, and
// InvalidQosOverridesException for values that say nothing.
ParameterValue get_default_qos_param_value(QosPolicyKind policy, const QoS & qos);
void apply_qos_override(QosPolicyKind policy, const ParameterValue & value, QoS & qos);

/// Throws std::runtime_error for policies of something that has no parameters.
template<typename NodeT, typename TraitsT>
QoS declare_qos_parameters(
  const QosOverridingOptions & options, NodeT & node, const std::string & topic_name,
  const QoS & default_qos, TraitsT)
{
  if constexpr (has_parameters<NodeT>::value) {
    return overridden_qos(
      *node_interfaces::get_node_parameters_interface(node), topic_name, TraitsT::entity_type(),
      default_qos, options);
  } else {
    if (!options.get_policy_kinds().empty()) {
      throw std::runtime_error("passed node-like object does not have parameters");
    }
    return default_qos;
  }
}

}  // namespace rclcpp::detail
