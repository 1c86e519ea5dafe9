#include "rclcpp/service.hpp"

#include <stdexcept>
#include <utility>

#include "names.hpp"
#include "qos_actual.hpp"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp
{

namespace
{

std::shared_ptr<rcl_service_t> make_service(
  std::shared_ptr<rcl_node_t> node, const std::string & name,
  const rosidl_service_type_support_t & type_support, const QoS & qos)
{
  auto service = std::make_unique<rcl_service_t>(rcl_get_zero_initialized_service());
  rcl_service_options_t options = rcl_service_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  const rcl_ret_t ret =
    rcl_service_init(service.get(), node.get(), &type_support, name.c_str(), &options);
  if (ret != RCL_RET_OK) {
    detail::throw_for_name(ret, *node, name.c_str(), true, "could not create service");
  }
  return {service.release(), [node = std::move(node)](rcl_service_t * gone) {
      if (rcl_service_fini(gone, node.get()) != RCL_RET_OK) {
        rcl_reset_error();
      }
      std::default_delete<rcl_service_t>()(gone);
    }};
}

}  // namespace

ServiceBase::ServiceBase(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & service_name,
  const rosidl_service_type_support_t & type_support, const QoS & qos)
: type_support_(type_support), node_handle_(node->get_shared_rcl_node_handle()),
  handle_(make_service(node_handle_, service_name, type_support, qos))
{
}

ServiceBase::ServiceBase(
  std::shared_ptr<rcl_node_t> node_handle, std::shared_ptr<rcl_service_t> service_handle,
  const rosidl_service_type_support_t & type_support)
: type_support_(type_support), node_handle_(std::move(node_handle)), handle_(std::move(service_handle))
{
  if (!rcl_service_is_valid(handle_.get())) {
    rcl_reset_error();
    throw std::runtime_error("rcl_service_t in constructor argument must be initialized beforehand.");
  }
}

ServiceBase::~ServiceBase()
{
  try {
    clear_on_new_request_callback();  // others may hold the handle for longer
  } catch (const std::exception &) {
    rcl_reset_error();
  }
}

void ServiceBase::set_on_new_request_callback(std::function<void(std::size_t)> callback)
{
  on_new_.set(
    std::move(callback), [this](rcl_event_callback_t function, const void * data) {
      return rcl_service_set_on_new_request_callback(handle_.get(), function, data);
    }, "set_on_new_request_callback");
}

void ServiceBase::clear_on_new_request_callback()
{
  on_new_.clear(
    [this](rcl_event_callback_t function, const void * data) {
      return rcl_service_set_on_new_request_callback(handle_.get(), function, data);
    });
}

const char * ServiceBase::get_service_name()
{
  return rcl_service_get_service_name(handle_.get());
}

QoS ServiceBase::get_request_subscription_actual_qos() const
{
  return detail::actual_qos(rcl_service_request_subscription_get_actual_qos(handle_.get()));
}

QoS ServiceBase::get_response_publisher_actual_qos() const
{
  return detail::actual_qos(rcl_service_response_publisher_get_actual_qos(handle_.get()));
}

void ServiceBase::configure_introspection(
  Clock::SharedPtr clock, const QoS & qos_service_event_pub,
  rcl_service_introspection_state_t introspection_state)
{
  rcl_publisher_options_t options = rcl_publisher_get_default_options();
  options.qos = qos_service_event_pub.get_rmw_qos_profile();
  detail::check(
    rcl_service_configure_service_introspection(
      handle_.get(), node_handle_.get(), clock->get_clock_handle(), &type_support_, options,
      introspection_state),
    "failed to configure service introspection");
  clock_ = std::move(clock);
}

bool ServiceBase::take_type_erased_request(void * request_out, rmw_request_id_t & request_id_out)
{
  const rcl_ret_t ret = rcl_take_request(handle_.get(), &request_id_out, request_out);
  if (ret == RCL_RET_SERVICE_TAKE_FAILED) {
    rcl_reset_error();
    return false;
  }
  detail::check(ret, "failed to take a request");
  return true;
}

void ServiceBase::execute()
{
  auto header = std::make_shared<rmw_request_id_t>();
  auto request = create_request();
  if (take_type_erased_request(request.get(), *header)) {
    handle_request(std::move(header), std::move(request));
  }
}

void ServiceBase::send_untyped(rmw_request_id_t & request_id, void * response)
{
  const rcl_ret_t ret = rcl_send_response(handle_.get(), &request_id, response);
  if (ret == RCL_RET_TIMEOUT) {
    RCLCPP_WARN(
      get_logger("rclcpp"), "failed to send response to %s (timeout): %s", get_service_name(),
      rcl_get_error_string().str);
    rcl_reset_error();
    return;
  }
  detail::check(ret, "failed to send response");
}

}  // namespace rclcpp
