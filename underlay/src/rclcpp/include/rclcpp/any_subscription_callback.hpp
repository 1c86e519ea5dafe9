#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "rclcpp/detail/local_message.hpp"
#include "rclcpp/message_info.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/type_adapter.hpp"

namespace rclcpp::detail
{

/// What is done with a message. With `owns_messages`, it may be changed: nobody else may have it.
template<typename MessageT>
struct MessageHandler : std::function<void(std::shared_ptr<MessageT> &&, const MessageInfo &)>
{
  using Function = std::function<void(std::shared_ptr<MessageT> &&, const MessageInfo &)>;

  MessageHandler() = default;
  MessageHandler(Function function, bool owns)
  : Function(std::move(function)), owns_messages(owns) {}
  /// A function that takes the shared pointer itself may do with the message what it wants.
  template<
    typename FunctionT,
    std::enable_if_t<
      !std::is_base_of_v<MessageHandler, FunctionT> && std::is_constructible_v<Function, FunctionT>, int> = 0>
  MessageHandler(FunctionT function)  // NOLINT: it stands for one
  : MessageHandler(Function(std::move(function)), true) {}

  bool owns_messages = false;
};

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
    callback(unique_from_shared(std::move(message)), info ...);
  }
}

/// Whether it takes the message in a form that it may change. Step by step, as in call_with.
template<typename MessageT, typename CallbackT, typename ... Info>
constexpr bool may_change()
{
  if constexpr (std::is_invocable_v<CallbackT &, const MessageT &, const Info &...>) {
    return false;
  } else {
    return !std::is_invocable_v<CallbackT &, std::shared_ptr<const MessageT>, const Info &...>;
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
    return {
      [callback = Given(std::forward<CallbackT>(callback))](
        std::shared_ptr<MessageT> && message, const MessageInfo &) mutable {
        call_with<MessageT>(callback, std::move(message));
      }, may_change<MessageT, Given>()};
  } else if constexpr (takes<MessageT, Given, MessageInfo>) {
    return {
      [callback = Given(std::forward<CallbackT>(callback))](
        std::shared_ptr<MessageT> && message, const MessageInfo & info) mutable {
        call_with<MessageT>(callback, std::move(message), info);
      }, may_change<MessageT, Given, MessageInfo>()};
  } else {
    static_assert(
      always_false<Given>,
      "the callback of a subscription takes a const reference, a shared or a unique pointer to the message");
  }
}

/// Gives what the adapter makes of a message to a callback that takes that.
template<typename AdapterT, typename CallbackT>
auto adapting_handler(CallbackT && callback)
{
  using Custom = typename AdapterT::custom_type;
  using Message = typename AdapterT::ros_message_type;
  return MessageHandler<Message>(
    [handler = message_handler<Custom>(std::forward<CallbackT>(callback))](
      std::shared_ptr<Message> && message, const MessageInfo & info) {
      auto custom = std::make_unique<Custom>();
      AdapterT::convert_to_custom(*message, *custom);
      handler(shared_from_unique(std::move(custom)), info);
    }, false);
}

/// Of a message or what an adapter makes of it. Step by step, as above.
template<typename AdapterT, typename CallbackT>
auto adapted_handler(CallbackT && callback)
{
  using Given = std::decay_t<CallbackT>;
  using Custom = typename AdapterT::custom_type;
  if constexpr (takes<Custom, Given>) {
    return adapting_handler<AdapterT>(std::forward<CallbackT>(callback));
  } else if constexpr (takes<Custom, Given, MessageInfo>) {
    return adapting_handler<AdapterT>(std::forward<CallbackT>(callback));
  } else {
    return message_handler<typename AdapterT::ros_message_type>(std::forward<CallbackT>(callback));
  }
}

/// The same, and for callbacks that take the bytes.
template<typename MessageT, typename CallbackT>
auto subscription_handler(CallbackT && callback)
{
  using Adapter = TypeAdapter<MessageT>;
  if constexpr (may_take_serialized<std::decay_t<CallbackT>, typename Adapter::custom_type>()) {
    return message_handler<SerializedMessage>(std::forward<CallbackT>(callback));
  } else if constexpr (Adapter::is_specialized::value) {
    return adapted_handler<Adapter>(std::forward<CallbackT>(callback));
  } else {
    return message_handler<MessageT>(std::forward<CallbackT>(callback));
  }
}

}  // namespace rclcpp::detail

namespace rclcpp
{

/// A callback of a subscription, in any of its forms.
template<typename MessageT, typename AllocatorT = std::allocator<void>>
class AnySubscriptionCallback
{
public:
  using SubscribedType = typename TypeAdapter<MessageT>::custom_type;
  using ROSMessageType = typename TypeAdapter<MessageT>::ros_message_type;

  /// Messages are allocated as everywhere, whatever the allocator.
  explicit AnySubscriptionCallback(const AllocatorT & = AllocatorT()) {}

  template<typename CallbackT>
  AnySubscriptionCallback & set(CallbackT && callback)
  {
    auto handler = detail::subscription_handler<MessageT>(std::forward<CallbackT>(callback));
    if constexpr (std::is_same_v<decltype(handler), decltype(handler_)>) {
      handler_ = std::move(handler);
    } else {
      serialized_handler_ = std::move(handler);
    }
    return *this;
  }

  bool is_serialized_message_callback() const {return static_cast<bool>(serialized_handler_);}
  /// Whether the callback only reads the message.
  bool use_take_shared_method() const {return !handler_.owns_messages;}

  // These throw std::runtime_error without a callback for what they are given.
  void dispatch(std::shared_ptr<ROSMessageType> message, const MessageInfo & message_info)
  {
    call(handler_, std::move(message), message_info);
  }
  void dispatch(std::shared_ptr<SerializedMessage> serialized_message, const MessageInfo & message_info)
  {
    call(serialized_handler_, std::move(serialized_message), message_info);
  }
  /// Copies the message for a callback that may change it.
  void dispatch_intra_process(
    const std::shared_ptr<const SubscribedType> & message, const MessageInfo & message_info)
  {
    if constexpr (TypeAdapter<MessageT>::is_specialized::value) {
      dispatch(converted(*message), message_info);
    } else if (handler_.owns_messages) {
      dispatch_intra_process(std::make_unique<SubscribedType>(*message), message_info);
    } else {
      dispatch(std::const_pointer_cast<SubscribedType>(message), message_info);
    }
  }
  void dispatch_intra_process(std::unique_ptr<SubscribedType> message, const MessageInfo & message_info)
  {
    if constexpr (TypeAdapter<MessageT>::is_specialized::value) {
      dispatch(converted(*message), message_info);
    } else {
      dispatch(detail::shared_from_unique(std::move(message)), message_info);
    }
  }

private:
  template<typename T>
  static void call(
    detail::MessageHandler<T> & handler, std::shared_ptr<T> message, const MessageInfo & message_info)
  {
    if (!handler) {
      throw std::runtime_error("dispatch called on an unset AnySubscriptionCallback");
    }
    handler(std::move(message), message_info);
  }

  static std::shared_ptr<ROSMessageType> converted(const SubscribedType & message)
  {
    auto made = std::make_unique<ROSMessageType>();
    TypeAdapter<MessageT>::convert_to_ros_message(message, *made);
    return detail::shared_from_unique(std::move(made));
  }

  detail::MessageHandler<ROSMessageType> handler_;
  detail::SerializedHandler serialized_handler_;
};

}  // namespace rclcpp
