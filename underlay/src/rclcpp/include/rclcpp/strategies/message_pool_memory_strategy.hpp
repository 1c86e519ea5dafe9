#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <vector>

#include "rclcpp/message_memory_strategy.hpp"

namespace rclcpp::strategies::message_pool_memory_strategy
{

/// Makes messages in the same memory again and again: no more than `Size` of them exist at a time.
template<typename MessageT, std::size_t Size>
class MessagePoolMemoryStrategy : public message_memory_strategy::MessageMemoryStrategy<MessageT>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MessagePoolMemoryStrategy)

  /// Throws std::runtime_error if all are in use.
  std::shared_ptr<MessageT> borrow_message() override
  {
    auto * const place = pool_->take();
    if (!place) {
      throw std::runtime_error("No more free slots in the pool");
    }
    return {new(place) MessageT(), [pool = pool_](MessageT * message) {
        message->~MessageT();
        pool->give_back(message);
      }};
  }

  /// Its memory is free once nobody else refers to the message.
  void return_message(std::shared_ptr<MessageT> &) override {}

private:
  class Pool
  {
public:
    Pool()
    {
      for (auto & place : places_) {
        free_.push_back(&place);
      }
    }
    void * take()
    {
      const std::lock_guard lock(mutex_);
      if (free_.empty()) {
        return nullptr;
      }
      void * const place = free_.back();
      free_.pop_back();
      return place;
    }
    void give_back(void * place)
    {
      const std::lock_guard lock(mutex_);
      free_.push_back(place);
    }

private:
    struct alignas(MessageT) Place {std::byte bytes[sizeof(MessageT)];};

    std::mutex mutex_;
    std::array<Place, Size> places_;
    std::vector<void *> free_;
  };

  std::shared_ptr<Pool> pool_ = std::make_shared<Pool>();
};

}  // namespace rclcpp::strategies::message_pool_memory_strategy
