#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/detail/node_of.hpp"
#include "rclcpp/detail/qos_parameters.hpp"

namespace rclcpp
{

template<typename MessageT, typename CallbackT, typename AllocatorT = std::allocator<void>, typename NodeT>
std::shared_ptr<Subscription<MessageT, AllocatorT>> create_subscription(
  NodeT && node, const std::string & topic_name, const QoS & qos, CallbackT && callback,
  const SubscriptionOptionsWithAllocator<AllocatorT> & options =
  SubscriptionOptionsWithAllocator<AllocatorT>())
{
  auto & given = detail::node_of(node);
  if constexpr (std::is_same_v<std::decay_t<decltype(given)>, node_interfaces::NodeTopicsInterface>) {
    const auto base = given.get_node_base_interface();
    auto subscription = std::make_shared<Subscription<MessageT, AllocatorT>>(
      base, topic_name, qos,
      detail::subscription_handler<MessageT>(std::forward<CallbackT>(callback)), options);
    base->add(subscription, options.callback_group);
    return subscription;
  } else {
    return given.template create_subscription<MessageT>(
      topic_name, qos, std::forward<CallbackT>(callback), options);
  }
}

/// The same, of parts of a node: with the options, parameters may set policies of the QoS.
template<typename MessageT, typename CallbackT, typename AllocatorT = std::allocator<void>,
  typename ParametersT, typename TopicsT>
std::shared_ptr<Subscription<MessageT, AllocatorT>> create_subscription(
  ParametersT & node_parameters, TopicsT & node_topics, const std::string & topic_name, const QoS & qos,
  CallbackT && callback,
  const SubscriptionOptionsWithAllocator<AllocatorT> & options =
  SubscriptionOptionsWithAllocator<AllocatorT>())
{
  const auto topics = node_interfaces::get_node_topics_interface(node_topics);
  const auto & overriding = options.qos_overriding_options;
  return create_subscription<MessageT>(
    topics, topic_name,
    overriding.get_policy_kinds().empty() ? qos :
    detail::declare_qos_parameters(
      overriding, node_parameters, topics->resolve_topic_name(topic_name), qos,
      detail::SubscriptionQosParametersTraits()),
    std::forward<CallbackT>(callback), options);
}

}  // namespace rclcpp
