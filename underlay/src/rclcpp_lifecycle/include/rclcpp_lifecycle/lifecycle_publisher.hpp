#pragma once

#include <atomic>
#include <memory>
#include <utility>

#include "rclcpp/logging.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp_lifecycle/managed_entity.hpp"

namespace rclcpp_lifecycle
{

/// Publishes while its node is active, and says once when it does not.
template<typename MessageT, typename AllocatorT = std::allocator<void>>
class LifecyclePublisher : public SimpleManagedEntity, public rclcpp::Publisher<MessageT, AllocatorT>
{
  using Base = rclcpp::Publisher<MessageT, AllocatorT>;

public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecyclePublisher<MessageT, AllocatorT>)

  using Base::Base;

  /// In each form in which a publisher takes messages.
  template<typename GivenT>
  void publish(GivenT && message)
  {
    if (is_activated()) {
      Base::publish(std::forward<GivenT>(message));
    } else {
      tell_once();
    }
  }
  void publish(const typename Base::ROSMessageType & message)
  {
    publish<const typename Base::ROSMessageType &>(message);
  }

  void on_activate() override
  {
    SimpleManagedEntity::on_activate();
    was_told_ = false;
  }

private:
  void tell_once()
  {
    if (!was_told_.exchange(true)) {
      RCLCPP_WARN(
        rclcpp::get_logger("LifecyclePublisher"),
        "Trying to publish message on the topic '%s', but the publisher is not activated",
        this->get_topic_name());
    }
  }

  std::atomic<bool> was_told_{false};
};

}  // namespace rclcpp_lifecycle
