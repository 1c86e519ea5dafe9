#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "rcl/allocator.h"
#include "rclcpp/allocator/allocator_deleter.hpp"

namespace rclcpp::allocator
{

template<typename T, typename Alloc>
using AllocRebind = typename std::allocator_traits<Alloc>::template rebind_traits<T>;

// Allocators of C++ as the functions that an allocator of C consists of. Each throws std::runtime_error for a
// null pointer to the allocator.

template<typename Alloc>
Alloc & retyped(void * untyped_allocator)
{
  if (!untyped_allocator) {
    throw std::runtime_error("Received incorrect allocator type");
  }
  return *static_cast<Alloc *>(untyped_allocator);
}

template<typename Alloc>
void * retyped_allocate(std::size_t size, void * untyped_allocator)
{
  return std::allocator_traits<Alloc>::allocate(retyped<Alloc>(untyped_allocator), size);
}

template<typename Alloc>
void * retyped_zero_allocate(std::size_t number_of_elem, std::size_t size_of_elem, void * untyped_allocator)
{
  const std::size_t size = number_of_elem * size_of_elem;
  void * const memory = retyped_allocate<Alloc>(size, untyped_allocator);
  return memory ? std::memset(memory, 0, size) : nullptr;
}

template<typename T, typename Alloc>
void retyped_deallocate(void * untyped_pointer, void * untyped_allocator)
{
  std::allocator_traits<Alloc>::deallocate(
    retyped<Alloc>(untyped_allocator), static_cast<T *>(untyped_pointer), 1);
}

/// What was in the old memory is lost.
template<typename T, typename Alloc>
void * retyped_reallocate(void * untyped_pointer, std::size_t size, void * untyped_allocator)
{
  retyped_deallocate<T, Alloc>(untyped_pointer, untyped_allocator);
  return retyped_allocate<Alloc>(size, untyped_allocator);
}

/// The allocator must outlive the result.
template<typename T, typename Alloc>
rcl_allocator_t get_rcl_allocator(Alloc & allocator)
{
  rcl_allocator_t result = rcl_get_default_allocator();
  if constexpr (!std::is_same_v<Alloc, std::allocator<void>>) {
    result.allocate = &retyped_allocate<Alloc>;
    result.zero_allocate = &retyped_zero_allocate<Alloc>;
    result.deallocate = &retyped_deallocate<T, Alloc>;
    result.reallocate = &retyped_reallocate<T, Alloc>;
    result.state = &allocator;
  }
  return result;
}

}  // namespace rclcpp::allocator
