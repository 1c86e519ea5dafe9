#include "rclcpp/client.hpp"

#include <utility>

#include "graph_wait.hpp"
#include "names.hpp"
#include "qos_actual.hpp"
#include "rcl/graph.h"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp
{

namespace
{

std::shared_ptr<rcl_client_t> make_client(
  std::shared_ptr<rcl_node_t> node, const std::string & name,
  const rosidl_service_type_support_t & type_support, const QoS & qos)
{
  auto client = std::make_unique<rcl_client_t>(rcl_get_zero_initialized_client());
  rcl_client_options_t options = rcl_client_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  const rcl_ret_t ret =
    rcl_client_init(client.get(), node.get(), &type_support, name.c_str(), &options);
  if (ret != RCL_RET_OK) {
    detail::throw_for_name(ret, *node, name.c_str(), true, "could not create client");
  }
  return {client.release(), [node = std::move(node)](rcl_client_t * gone) {
      if (rcl_client_fini(gone, node.get()) != RCL_RET_OK) {
        rcl_reset_error();
      }
      std::default_delete<rcl_client_t>()(gone);
    }};
}

}  // namespace

ClientBase::ClientBase(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & service_name,
  const rosidl_service_type_support_t & type_support, const QoS & qos)
: type_support_(type_support), node_handle_(node->get_shared_rcl_node_handle()),
  context_(node->get_context()),
  handle_(make_client(node_handle_, service_name, type_support, qos))
{
}

ClientBase::~ClientBase()
{
  try {
    clear_on_new_response_callback();  // others may hold the handle for longer
  } catch (const std::exception &) {
    rcl_reset_error();
  }
}

void ClientBase::set_on_new_response_callback(std::function<void(std::size_t)> callback)
{
  on_new_.set(
    std::move(callback), [this](rcl_event_callback_t function, const void * data) {
      return rcl_client_set_on_new_response_callback(handle_.get(), function, data);
    }, "set_on_new_response_callback");
}

void ClientBase::clear_on_new_response_callback()
{
  on_new_.clear(
    [this](rcl_event_callback_t function, const void * data) {
      return rcl_client_set_on_new_response_callback(handle_.get(), function, data);
    });
}

const char * ClientBase::get_service_name() const
{
  return rcl_client_get_service_name(handle_.get());
}

QoS ClientBase::get_request_publisher_actual_qos() const
{
  return detail::actual_qos(rcl_client_request_publisher_get_actual_qos(handle_.get()));
}

QoS ClientBase::get_response_subscription_actual_qos() const
{
  return detail::actual_qos(rcl_client_response_subscription_get_actual_qos(handle_.get()));
}

bool ClientBase::service_is_ready() const
{
  bool is_ready = false;
  const rcl_ret_t ret = rcl_service_server_is_available(node_handle_.get(), handle_.get(), &is_ready);
  if (ret == RCL_RET_NODE_INVALID && !context_->is_valid()) {
    rcl_reset_error();
    return false;
  }
  detail::check(ret, "rcl_service_server_is_available failed");
  return is_ready;
}

bool ClientBase::wait_for_service_nanoseconds(std::chrono::nanoseconds timeout)
{
  return detail::wait_for_graph(
    node_handle_, context_, [this]() {return service_is_ready();}, timeout);
}

std::int64_t ClientBase::send_untyped(const void * request, Answered answered)
{
  std::int64_t id = 0;
  const std::lock_guard lock(pending_mutex_);  // the answer may be here before the number is
  detail::check(rcl_send_request(handle_.get(), request, &id), "failed to send request");
  pending_.emplace(id, Pending{std::chrono::system_clock::now(), std::move(answered)});
  return id;
}

void ClientBase::configure_introspection(
  Clock::SharedPtr clock, const QoS & qos_service_event_pub,
  rcl_service_introspection_state_t introspection_state)
{
  rcl_publisher_options_t options = rcl_publisher_get_default_options();
  options.qos = qos_service_event_pub.get_rmw_qos_profile();
  detail::check(
    rcl_client_configure_service_introspection(
      handle_.get(), node_handle_.get(), clock->get_clock_handle(), &type_support_, options,
      introspection_state),
    "failed to configure client introspection");
  clock_ = std::move(clock);
}

bool ClientBase::take_type_erased_response(void * response_out, rmw_request_id_t & request_header_out)
{
  const rcl_ret_t ret = rcl_take_response(handle_.get(), &request_header_out, response_out);
  if (ret == RCL_RET_CLIENT_TAKE_FAILED) {
    rcl_reset_error();
    return false;
  }
  detail::check(ret, "failed to take a response");
  return true;
}

void ClientBase::handle_response(
  std::shared_ptr<rmw_request_id_t> request_header, std::shared_ptr<void> response)
{
  Answered answered;
  {
    const std::lock_guard lock(pending_mutex_);
    const auto found = pending_.find(request_header->sequence_number);
    if (found == pending_.end()) {
      RCLCPP_DEBUG(get_logger("rclcpp"), "Received invalid sequence number. Ignoring...");
      return;
    }
    answered = std::move(found->second.answered);
    pending_.erase(found);
  }
  answered(std::move(response));
}

void ClientBase::execute()
{
  auto header = std::make_shared<rmw_request_id_t>();
  auto response = create_response();
  if (take_type_erased_response(response.get(), *header)) {
    handle_response(std::move(header), std::move(response));
  }
}

bool ClientBase::remove_pending_request(std::int64_t request_id)
{
  const std::lock_guard lock(pending_mutex_);
  return pending_.erase(request_id) != 0;
}

std::size_t ClientBase::prune_pending_requests()
{
  const std::lock_guard lock(pending_mutex_);
  const std::size_t count = pending_.size();
  pending_.clear();
  return count;
}

std::size_t ClientBase::prune_requests_older_than_time(
  std::chrono::system_clock::time_point time_point, std::vector<std::int64_t> * pruned_requests)
{
  const std::lock_guard lock(pending_mutex_);
  const std::size_t before = pending_.size();
  for (auto it = pending_.begin(); it != pending_.end(); ) {
    if (it->second.sent >= time_point) {
      ++it;
      continue;
    }
    if (pruned_requests) {
      pruned_requests->push_back(it->first);
    }
    it = pending_.erase(it);
  }
  return before - pending_.size();
}

}  // namespace rclcpp
