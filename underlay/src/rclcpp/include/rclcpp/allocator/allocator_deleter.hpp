#pragma once

#include <memory>
#include <stdexcept>
#include <type_traits>

namespace rclcpp::allocator
{

/// Deletes what an allocator has made. It does not own the allocator.
template<typename Allocator>
class AllocatorDeleter
{
public:
  AllocatorDeleter() = default;
  explicit AllocatorDeleter(Allocator * allocator) : allocator_(allocator) {}
  template<typename OtherT>
  explicit AllocatorDeleter(const AllocatorDeleter<OtherT> & other) : allocator_(other.get_allocator()) {}

  template<typename T>
  void operator()(T * object)
  {
    typename std::allocator_traits<Allocator>::template rebind_alloc<T> allocator(*allocator_);
    std::allocator_traits<decltype(allocator)>::destroy(allocator, object);
    std::allocator_traits<decltype(allocator)>::deallocate(allocator, object, 1);
  }

  Allocator * get_allocator() const {return allocator_;}
  void set_allocator(Allocator * allocator) {allocator_ = allocator;}

private:
  Allocator * allocator_ = nullptr;
};

/// The deleter for objects of an allocator: the usual one, if that is the standard allocator.
template<typename Alloc, typename T>
using Deleter = std::conditional_t<
  std::is_same_v<typename std::allocator_traits<Alloc>::template rebind_alloc<T>, std::allocator<T>>,
  std::default_delete<T>, AllocatorDeleter<Alloc>>;

/// Lets the deleter use the allocator. Throws std::runtime_error for deleters that use none.
template<typename Alloc, typename T, typename DeleterT>
void set_allocator_for_deleter(DeleterT *, Alloc *)
{
  throw std::runtime_error("Reached unexpected template specialization");
}

template<typename T, typename U>
void set_allocator_for_deleter(std::default_delete<T> *, std::allocator<U> *)
{
}

/// Throws std::invalid_argument for null pointers.
template<typename Alloc, typename T>
void set_allocator_for_deleter(AllocatorDeleter<T> * deleter, Alloc * allocator)
{
  if (!deleter || !allocator) {
    throw std::invalid_argument("Argument was NULL to set_allocator_for_deleter");
  }
  deleter->set_allocator(allocator);
}

}  // namespace rclcpp::allocator
