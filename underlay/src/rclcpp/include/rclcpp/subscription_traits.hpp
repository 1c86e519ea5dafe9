#pragma once

#include <memory>
#include <type_traits>

#include "rclcpp/function_traits.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/subscription_options.hpp"

namespace rclcpp::subscription_traits
{

/// Whether it is a message as bytes, or a shared pointer to one.
template<typename T>
struct is_serialized_subscription_argument : std::is_same<T, SerializedMessage> {};
template<typename T>
struct is_serialized_subscription_argument<std::shared_ptr<T>>: std::is_same<T, SerializedMessage> {};

template<typename T>
struct is_serialized_subscription : is_serialized_subscription_argument<T> {};

/// Whether a callback takes messages as bytes.
template<typename CallbackT>
struct is_serialized_callback
  : is_serialized_subscription_argument<
    typename function_traits::function_traits<CallbackT>::template argument_type<0>> {};

/// The message, of which a reference or a pointer may be given.
template<typename MessageT>
struct extract_message_type
{
  using type = std::remove_cv_t<std::remove_reference_t<MessageT>>;
};
template<typename MessageT>
struct extract_message_type<std::shared_ptr<MessageT>>: extract_message_type<MessageT> {};
template<typename MessageT, typename DeleterT>
struct extract_message_type<std::unique_ptr<MessageT, DeleterT>>: extract_message_type<MessageT> {};

/// The message that a callback takes. Not for the numbers, QoS and options that may stand in its place.
template<
  typename CallbackT, typename AllocatorT = std::allocator<void>,
  typename GivenT = std::remove_cv_t<std::remove_reference_t<CallbackT>>,
  typename = std::enable_if_t<
    !std::is_integral_v<GivenT> && !std::is_base_of_v<QoS, GivenT> &&
    !std::is_same_v<rmw_qos_profile_t, GivenT> &&
    !std::is_same_v<SubscriptionOptionsWithAllocator<AllocatorT>, GivenT>>>
struct has_message_type
  : extract_message_type<
    typename function_traits::function_traits<CallbackT>::template argument_type<0>> {};

}  // namespace rclcpp::subscription_traits
