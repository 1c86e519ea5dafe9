#include "rclcpp/waitable.hpp"

#include <stdexcept>
#include <string>

namespace rclcpp
{

namespace
{

[[noreturn]] void must_be_overridden(const char * method)
{
  throw std::runtime_error(
          "Custom waitables should override " + std::string(method) + " to be used by an executor.");
}

}  // namespace

void detail::WaitableEntity::execute()
{
  const std::shared_ptr<void> data = waitable_.take_data();
  waitable_.execute(data);
}

std::shared_ptr<detail::Entity> detail::entity_of(const std::shared_ptr<Waitable> & waitable)
{
  return waitable ? std::shared_ptr<Entity>(waitable, &waitable->entity_) : nullptr;
}

void Waitable::add_to_wait_set(rcl_wait_set_t & wait_set)
{
  add_to_wait_set(&wait_set);
}

void Waitable::add_to_wait_set(rcl_wait_set_t *)
{
  must_be_overridden("add_to_wait_set");
}

bool Waitable::is_ready(const rcl_wait_set_t & wait_set)
{
  rcl_wait_set_t copy = wait_set;
  return is_ready(&copy);
}

bool Waitable::is_ready(rcl_wait_set_t *)
{
  must_be_overridden("is_ready");
}

void Waitable::execute(const std::shared_ptr<void> & data)
{
  std::shared_ptr<void> copy = data;
  execute(copy);
}

void Waitable::execute(std::shared_ptr<void> &)
{
  must_be_overridden("execute");
}

std::shared_ptr<void> Waitable::take_data_by_entity_id(std::size_t)
{
  must_be_overridden("take_data_by_entity_id");
}

void Waitable::set_on_ready_callback(std::function<void(std::size_t, int)>)
{
  must_be_overridden("set_on_ready_callback");
}

void Waitable::clear_on_ready_callback()
{
  must_be_overridden("clear_on_ready_callback");
}

}  // namespace rclcpp
