#pragma once

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "rclcpp/message_info.hpp"
#include "rclcpp/serialized_message.hpp"

namespace rclcpp::detail
{

template<typename MessageT>
using MessageHandler = std::function<void(std::shared_ptr<MessageT> &&, const MessageInfo &)>;

using SerializedHandler = MessageHandler<SerializedMessage>;

template<typename>
inline constexpr bool always_false = false;

/// Calls `callback` with the message in the form in which it takes it.
template<typename MessageT, typename CallbackT, typename ... Info>
void call_with(CallbackT & callback, std::shared_ptr<MessageT> && message, const Info & ... info)
{
  if constexpr (std::is_invocable_v<CallbackT &, const MessageT &, const Info &...>) {
    callback(static_cast<const MessageT &>(*message), info ...);
  } else if constexpr (std::is_invocable_v<CallbackT &, std::shared_ptr<const MessageT>, const Info &...>) {
    callback(std::shared_ptr<const MessageT>(std::move(message)), info ...);
  } else if constexpr (std::is_invocable_v<CallbackT &, std::shared_ptr<MessageT>, const Info &...>) {
    callback(std::move(message), info ...);
  } else {
    callback(std::make_unique<MessageT>(std::move(*message)), info ...);
  }
}

// One by one: a lambda that takes `const auto &` is not looked at with pointers.
template<typename MessageT, typename CallbackT, typename ... Info>
inline constexpr bool takes = std::disjunction_v<
  std::is_invocable<CallbackT &, const MessageT &, const Info &...>,
  std::is_invocable<CallbackT &, std::shared_ptr<const MessageT>, const Info &...>,
  std::is_invocable<CallbackT &, std::shared_ptr<MessageT>, const Info &...>,
  std::is_invocable<CallbackT &, std::unique_ptr<MessageT>, const Info &...>>;

/// Whether the callback takes messages as bytes, and not as messages. Step by step, as above.
template<typename CallbackT, typename MessageT>
constexpr bool may_take_serialized()
{
  if constexpr (takes<MessageT, CallbackT>) {
    return false;
  } else if constexpr (takes<MessageT, CallbackT, MessageInfo>) {
    return false;
  } else if constexpr (takes<SerializedMessage, CallbackT>) {
    return true;
  } else {
    return takes<SerializedMessage, CallbackT, MessageInfo>;
  }
}

/// One form for callbacks of all forms.
template<typename MessageT, typename CallbackT>
MessageHandler<MessageT> message_handler(CallbackT && callback)
{
  using Given = std::decay_t<CallbackT>;
  if constexpr (takes<MessageT, Given>) {
    return [callback = Given(std::forward<CallbackT>(callback))](
      std::shared_ptr<MessageT> && message, const MessageInfo &) mutable {
             call_with<MessageT>(callback, std::move(message));
           };
  } else if constexpr (takes<MessageT, Given, MessageInfo>) {
    return [callback = Given(std::forward<CallbackT>(callback))](
      std::shared_ptr<MessageT> && message, const MessageInfo & info) mutable {
             call_with<MessageT>(callback, std::move(message), info);
           };
  } else {
    static_assert(
      always_false<Given>,
      "the callback of a subscription takes a const reference, a shared or a unique pointer to the message");
  }
}

/// The same, and for callbacks that take the bytes.
template<typename MessageT, typename CallbackT>
auto subscription_handler(CallbackT && callback)
{
  if constexpr (may_take_serialized<std::decay_t<CallbackT>, MessageT>()) {
    return message_handler<SerializedMessage>(std::forward<CallbackT>(callback));
  } else {
    return message_handler<MessageT>(std::forward<CallbackT>(callback));
  }
}

}  // namespace rclcpp::detail
