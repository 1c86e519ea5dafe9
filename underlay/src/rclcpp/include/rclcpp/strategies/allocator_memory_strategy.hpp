#pragma once

#include <memory>
#include <utility>

#include "rclcpp/allocator/allocator_common.hpp"
#include "rclcpp/memory_strategy.hpp"

namespace rclcpp::memory_strategies::allocator_memory_strategy
{

template<typename Alloc = std::allocator<void>>
class AllocatorMemoryStrategy : public memory_strategy::MemoryStrategy
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(AllocatorMemoryStrategy)

  AllocatorMemoryStrategy() : AllocatorMemoryStrategy(std::make_shared<Alloc>()) {}
  explicit AllocatorMemoryStrategy(std::shared_ptr<Alloc> allocator)
  : allocator_(std::make_shared<VoidAlloc>(*allocator)) {}

  rcl_allocator_t get_allocator() override {return allocator::get_rcl_allocator<void *>(*allocator_);}

private:
  using VoidAlloc = typename allocator::AllocRebind<void *, Alloc>::allocator_type;

  std::shared_ptr<VoidAlloc> allocator_;
};

}  // namespace rclcpp::memory_strategies::allocator_memory_strategy
