#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "rclcpp/publisher_base.hpp"

namespace rclcpp
{

/// A message to be filled in and given to Publisher::publish. Its memory is the program's in every case.
template<typename MessageT, typename AllocatorT = std::allocator<void>>
class LoanedMessage
{
public:
  using MessageAllocator = std::allocator<MessageT>;

  explicit LoanedMessage(const PublisherBase & publisher, MessageAllocator = MessageAllocator())
  : message_(std::make_unique<MessageT>())
  {
    publisher.tell_of_loans();
  }

  bool is_valid() const {return message_ != nullptr;}
  MessageT & get() const {return *message_;}
  std::unique_ptr<MessageT, std::function<void(MessageT *)>> release()
  {
    return {message_.release(), std::default_delete<MessageT>()};
  }

private:
  std::unique_ptr<MessageT> message_;
};

}  // namespace rclcpp
