#pragma once

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "rclcpp/clock.hpp"
#include "rclcpp/time.hpp"

namespace message_filters
{

/// A message, and when it came.
template<typename M>
class MessageEvent
{
public:
  using Message = std::remove_const_t<M>;
  using ConstMessage = std::add_const_t<M>;
  using MessagePtr = std::shared_ptr<Message>;
  using ConstMessagePtr = std::shared_ptr<ConstMessage>;

  MessageEvent() = default;
  MessageEvent(const ConstMessagePtr & message)  // NOLINT: as the real one has it
  : MessageEvent(message, rclcpp::Clock().now())
  {
  }
  MessageEvent(const ConstMessagePtr & message, rclcpp::Time receipt_time, bool nonconst_need_copy = true)
  : message_(message), receipt_time_(receipt_time), nonconst_need_copy_(nonconst_need_copy)
  {
  }
  /// Also makes events of messages that may be changed from those of others, and the other way around.
  template<typename OtherM, typename = std::enable_if_t<std::is_same_v<std::add_const_t<OtherM>, ConstMessage>>>
  MessageEvent(const MessageEvent<OtherM> & other)  // NOLINT: as the real one has it
  : MessageEvent(other, other.nonConstWillCopy())
  {
  }
  template<typename OtherM, typename = std::enable_if_t<std::is_same_v<std::add_const_t<OtherM>, ConstMessage>>>
  MessageEvent(const MessageEvent<OtherM> & other, bool nonconst_need_copy)
  : MessageEvent(other.getConstMessage(), other.getReceiptTime(), nonconst_need_copy)
  {
  }

  /// If it may be changed, this is a copy; unless nobody else has the message.
  std::shared_ptr<M> getMessage() const
  {
    if (!getMessageWillCopy() || !message_) {
      return std::const_pointer_cast<M>(message_);
    }
    if (!copy_) {
      copy_ = std::make_shared<Message>(*message_);
    }
    return copy_;
  }
  const ConstMessagePtr & getConstMessage() const {return message_;}
  rclcpp::Time getReceiptTime() const {return receipt_time_;}
  bool nonConstWillCopy() const {return nonconst_need_copy_;}
  bool getMessageWillCopy() const {return !std::is_const_v<M> && nonconst_need_copy_;}

  bool operator==(const MessageEvent & other) const
  {
    return message_ == other.message_ && receipt_time_ == other.receipt_time_ &&
           nonconst_need_copy_ == other.nonconst_need_copy_;
  }
  bool operator!=(const MessageEvent & other) const {return !(*this == other);}

private:
  ConstMessagePtr message_;
  mutable MessagePtr copy_;
  rclcpp::Time receipt_time_;
  bool nonconst_need_copy_ = true;
};

}  // namespace message_filters
