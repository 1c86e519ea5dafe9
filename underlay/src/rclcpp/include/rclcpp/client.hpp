#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rcl/client.h"
#include "rcl/service_introspection.h"
#include "rclcpp/any_subscription_callback.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/detail/entity.hpp"
#include "rclcpp/detail/event_callback.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rosidl_runtime_c/service_type_support_struct.h"
#include "rosidl_typesupport_cpp/service_type_support.hpp"

namespace rclcpp
{

namespace detail
{

/// A future, and the number under which its request can be forgotten.
template<typename FutureT>
struct FutureAndRequestId
{
  FutureT future;
  std::int64_t request_id;

  FutureAndRequestId(FutureT impl, std::int64_t req_id) : future(std::move(impl)), request_id(req_id) {}

  operator FutureT &() {return future;}  // NOLINT: as the future itself
  auto get() {return future.get();}
  bool valid() const noexcept {return future.valid();}
  void wait() const {future.wait();}
  template<class Rep, class Period>
  std::future_status wait_for(const std::chrono::duration<Rep, Period> & timeout_duration) const
  {
    return future.wait_for(timeout_duration);
  }
  template<class Clock, class Duration>
  std::future_status wait_until(const std::chrono::time_point<Clock, Duration> & timeout_time) const
  {
    return future.wait_until(timeout_time);
  }
};

}  // namespace detail

/// What clients of all types have in common.
class ClientBase : public detail::Entity
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ClientBase)
  RCLCPP_DISABLE_COPY(ClientBase)

  /// Throws InvalidServiceNameError, RCLError.
  ClientBase(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & service_name,
    const rosidl_service_type_support_t & type_support, const QoS & qos);
  ~ClientBase() override;

  const char * get_service_name() const;
  std::shared_ptr<rcl_client_t> get_client_handle() {return handle_;}
  std::shared_ptr<const rcl_client_t> get_client_handle() const {return handle_;}
  QoS get_request_publisher_actual_qos() const;
  QoS get_response_subscription_actual_qos() const;

  bool service_is_ready() const;

  /// Waits for the service; a negative time waits for ever. False when it did not come, or the context ended.
  template<typename RepT = std::int64_t, typename RatioT = std::milli>
  bool wait_for_service(
    std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1))
  {
    return wait_for_service_nanoseconds(
      std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }

  /// Forgets a request; an answer to it is then ignored. False when it is not pending.
  bool remove_pending_request(std::int64_t request_id);
  std::size_t prune_pending_requests();
  std::size_t prune_requests_older_than_time(
    std::chrono::system_clock::time_point time_point, std::vector<std::int64_t> * pruned_requests);

  /// Whether requests and answers are told on the topic `<service>/_service_event`, and what of them.
  void configure_introspection(
    Clock::SharedPtr clock, const QoS & qos_service_event_pub,
    rcl_service_introspection_state_t introspection_state);

  /// Takes the next answer without an executor; false when there is none.
  bool take_type_erased_response(void * response_out, rmw_request_id_t & request_header_out);

  virtual std::shared_ptr<void> create_response() = 0;

  /// Gives an answer to the one who waits for it.
  void handle_response(std::shared_ptr<rmw_request_id_t> request_header, std::shared_ptr<void> response);

  /// Called with the number of responses that have come, from a thread of the middleware, also for those that
  /// came before. Throws std::invalid_argument for an empty function, RCLError.
  void set_on_new_response_callback(std::function<void(std::size_t)> callback);
  void clear_on_new_response_callback();

  detail::EntityKind kind() const noexcept override {return detail::EntityKind::client;}
  const void * rcl_entity() const noexcept override {return handle_.get();}
  void execute() override;

protected:
  using Answered = std::function<void(std::shared_ptr<void>)>;

  /// Sends, and calls back with the response. Gives the number of the request.
  std::int64_t send_untyped(const void * request, Answered answered);
  bool wait_for_service_nanoseconds(std::chrono::nanoseconds timeout);

private:
  struct Pending
  {
    std::chrono::system_clock::time_point sent;
    Answered answered;
  };

  const rosidl_service_type_support_t & type_support_;
  std::shared_ptr<rcl_node_t> node_handle_;
  Context::SharedPtr context_;
  Clock::SharedPtr clock_;
  std::shared_ptr<rcl_client_t> handle_;
  detail::EventCallback on_new_;
  std::mutex pending_mutex_;
  std::map<std::int64_t, Pending> pending_;
};

template<typename ServiceT>
class Client : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Client<ServiceT>)
  using Request = typename ServiceT::Request;
  using Response = typename ServiceT::Response;
  using SharedRequest = typename ServiceT::Request::SharedPtr;
  using SharedResponse = typename ServiceT::Response::SharedPtr;
  using Promise = std::promise<SharedResponse>;
  using PromiseWithRequest = std::promise<std::pair<SharedRequest, SharedResponse>>;
  using SharedPromise = std::shared_ptr<Promise>;
  using SharedPromiseWithRequest = std::shared_ptr<PromiseWithRequest>;
  using Future = std::future<SharedResponse>;
  using SharedFuture = std::shared_future<SharedResponse>;
  using SharedFutureWithRequest = std::shared_future<std::pair<SharedRequest, SharedResponse>>;
  using CallbackType = std::function<void (SharedFuture)>;
  using CallbackWithRequestType = std::function<void (SharedFutureWithRequest)>;

  struct FutureAndRequestId : detail::FutureAndRequestId<Future>
  {
    using detail::FutureAndRequestId<Future>::FutureAndRequestId;
    SharedFuture share() noexcept {return this->future.share();}
  };
  struct SharedFutureAndRequestId : detail::FutureAndRequestId<SharedFuture>
  {
    using detail::FutureAndRequestId<SharedFuture>::FutureAndRequestId;
  };
  struct SharedFutureWithRequestAndRequestId : detail::FutureAndRequestId<SharedFutureWithRequest>
  {
    using detail::FutureAndRequestId<SharedFutureWithRequest>::FutureAndRequestId;
  };

  Client(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & service_name,
    const QoS & qos)
  : ClientBase(
      node, service_name, *rosidl_typesupport_cpp::get_service_type_support_handle<ServiceT>(), qos)
  {
  }

  /// Takes the next answer without an executor; false when there is none.
  bool take_response(Response & response_out, rmw_request_id_t & request_header_out)
  {
    return take_type_erased_response(&response_out, request_header_out);
  }

  std::shared_ptr<void> create_response() override {return std::make_shared<Response>();}

  /// Sends; the future is ready once the node has spun and the answer is there.
  FutureAndRequestId async_send_request(SharedRequest request)
  {
    const auto promise = std::make_shared<Promise>();
    auto future = promise->get_future();
    const auto id = send_untyped(
      request.get(), [promise](std::shared_ptr<void> response) {
        promise->set_value(std::static_pointer_cast<Response>(std::move(response)));
      });
    return FutureAndRequestId(std::move(future), id);
  }

  /// Sends; `callback` gets the future when it is ready.
  template<typename CallbackT, std::enable_if_t<std::is_invocable_v<CallbackT &, SharedFuture>, int> = 0>
  SharedFutureAndRequestId async_send_request(SharedRequest request, CallbackT && callback)
  {
    const auto promise = std::make_shared<Promise>();
    const SharedFuture future(promise->get_future());
    const auto id = send_untyped(
      request.get(),
      [promise, future, callback = CallbackType(std::forward<CallbackT>(callback))](
        std::shared_ptr<void> response) {
        promise->set_value(std::static_pointer_cast<Response>(std::move(response)));
        callback(future);
      });
    return SharedFutureAndRequestId(future, id);
  }

  /// The same; the future contains the request, too.
  template<typename CallbackT,
    std::enable_if_t<std::conjunction_v<
      std::negation<std::is_invocable<CallbackT &, SharedFuture>>,
      std::is_invocable<CallbackT &, SharedFutureWithRequest>>, int> = 0>
  SharedFutureWithRequestAndRequestId async_send_request(SharedRequest request, CallbackT && callback)
  {
    const auto promise = std::make_shared<PromiseWithRequest>();
    const SharedFutureWithRequest future(promise->get_future());
    const auto id = send_untyped(
      request.get(),
      [promise, future, request, callback = CallbackWithRequestType(std::forward<CallbackT>(callback))](
        std::shared_ptr<void> response) {
        promise->set_value({request, std::static_pointer_cast<Response>(std::move(response))});
        callback(future);
      });
    return SharedFutureWithRequestAndRequestId(future, id);
  }

  using ClientBase::remove_pending_request;
  bool remove_pending_request(const FutureAndRequestId & future)
  {
    return remove_pending_request(future.request_id);
  }
  bool remove_pending_request(const SharedFutureAndRequestId & future)
  {
    return remove_pending_request(future.request_id);
  }
  bool remove_pending_request(const SharedFutureWithRequestAndRequestId & future)
  {
    return remove_pending_request(future.request_id);
  }

  template<typename AllocatorT = std::allocator<std::int64_t>>
  std::size_t prune_requests_older_than(
    std::chrono::system_clock::time_point time_point,
    std::vector<std::int64_t, AllocatorT> * pruned_requests = nullptr)
  {
    return prune_requests_older_than_time(time_point, pruned_requests);
  }
};

}  // namespace rclcpp
