#pragma once

#include <memory>
#include <utility>

namespace rclcpp::detail
{

/// Lets a shared pointer that is the only one become a unique pointer to the same object.
template<typename MessageT>
struct Releasable
{
  bool was_released = false;
  void operator()(MessageT * message) const
  {
    if (!was_released) {
      std::default_delete<MessageT>()(message);
    }
  }
};

/// A shared pointer to the same object.
template<typename MessageT>
std::shared_ptr<MessageT> shared_from_unique(std::unique_ptr<MessageT> message)
{
  return {message.release(), Releasable<MessageT>()};
}

/// The same object where nobody else has it and it was made by `shared_from_unique`; else its contents moved
/// into another one. Nobody else may read it.
template<typename MessageT>
std::unique_ptr<MessageT> unique_from_shared(std::shared_ptr<MessageT> && message)
{
  auto * const deleter = std::get_deleter<Releasable<MessageT>>(message);
  if (deleter && message.use_count() == 1) {
    deleter->was_released = true;
    std::unique_ptr<MessageT> same(message.get());
    message.reset();
    return same;
  }
  return std::make_unique<MessageT>(std::move(*message));
}

using CloneMessage = std::shared_ptr<void> (*)(const void * message);

template<typename MessageT>
std::shared_ptr<void> clone_message(const void * message)
{
  return shared_from_unique(std::make_unique<MessageT>(*static_cast<const MessageT *>(message)));
}

}  // namespace rclcpp::detail
