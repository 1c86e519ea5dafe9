#pragma once

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rcl/service.h"
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

/// What services of all types have in common.
class ServiceBase : public detail::Entity
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ServiceBase)
  RCLCPP_DISABLE_COPY(ServiceBase)

  /// Throws InvalidServiceNameError, RCLError.
  ServiceBase(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & service_name,
    const rosidl_service_type_support_t & type_support, const QoS & qos);
  /// Of one that somebody else made. Throws std::runtime_error if it is not initialized.
  ServiceBase(
    std::shared_ptr<rcl_node_t> node_handle, std::shared_ptr<rcl_service_t> service_handle,
    const rosidl_service_type_support_t & type_support);
  ~ServiceBase() override;

  const char * get_service_name();
  std::shared_ptr<rcl_service_t> get_service_handle() {return handle_;}
  std::shared_ptr<const rcl_service_t> get_service_handle() const {return handle_;}
  QoS get_request_subscription_actual_qos() const;
  QoS get_response_publisher_actual_qos() const;

  /// Whether requests and answers are told on the topic `<service>/_service_event`, and what of them.
  void configure_introspection(
    Clock::SharedPtr clock, const QoS & qos_service_event_pub,
    rcl_service_introspection_state_t introspection_state);

  /// Takes the next request without an executor; false when there is none.
  bool take_type_erased_request(void * request_out, rmw_request_id_t & request_id_out);

  virtual std::shared_ptr<void> create_request() = 0;
  virtual void handle_request(
    std::shared_ptr<rmw_request_id_t> request_header, std::shared_ptr<void> request) = 0;

  /// Called with the number of requests that have come, from a thread of the middleware, also for those that
  /// came before. Throws std::invalid_argument for an empty function, RCLError.
  void set_on_new_request_callback(std::function<void(std::size_t)> callback);
  void clear_on_new_request_callback();

  detail::EntityKind kind() const noexcept override {return detail::EntityKind::service;}
  const void * rcl_entity() const noexcept override {return handle_.get();}
  void execute() override;

protected:
  void send_untyped(rmw_request_id_t & request_id, void * response);

private:
  const rosidl_service_type_support_t & type_support_;
  std::shared_ptr<rcl_node_t> node_handle_;
  Clock::SharedPtr clock_;
  std::shared_ptr<rcl_service_t> handle_;
  detail::EventCallback on_new_;
};

template<typename ServiceT>
class AnyServiceCallback;

template<typename ServiceT>
class Service : public ServiceBase, public std::enable_shared_from_this<Service<ServiceT>>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Service<ServiceT>)
  using Request = typename ServiceT::Request;
  using Response = typename ServiceT::Response;
  using Header = std::shared_ptr<rmw_request_id_t>;
  /// Gives what is to be answered, or nothing when that is sent later.
  using Handler = std::function<std::shared_ptr<Response>(
        Service *, const Header &, const std::shared_ptr<Request> &)>;

  Service(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & service_name,
    Handler handler, const QoS & qos)
  : ServiceBase(
      node, service_name, *rosidl_typesupport_cpp::get_service_type_support_handle<ServiceT>(), qos),
    handler_(std::move(handler))
  {
  }

  /// Of one that somebody else made.
  Service(
    std::shared_ptr<rcl_node_t> node_handle, std::shared_ptr<rcl_service_t> service_handle,
    AnyServiceCallback<ServiceT> any_callback)
  : ServiceBase(
      std::move(node_handle), std::move(service_handle),
      *rosidl_typesupport_cpp::get_service_type_support_handle<ServiceT>()),
    handler_(
      [any_callback](Service * self, const Header & header, const std::shared_ptr<Request> & request) mutable {
        return any_callback.dispatch(self->shared_from_this(), header, request);
      })
  {
  }
  /// The same. It must outlive this service, and stays to be finalized.
  Service(
    std::shared_ptr<rcl_node_t> node_handle, rcl_service_t * service_handle,
    AnyServiceCallback<ServiceT> any_callback)
  : Service(
      std::move(node_handle), std::shared_ptr<rcl_service_t>(service_handle, [](rcl_service_t *) {}),
      std::move(any_callback))
  {
  }

  /// Takes the next request without an executor; false when there is none.
  bool take_request(Request & request_out, rmw_request_id_t & request_id_out)
  {
    return take_type_erased_request(&request_out, request_id_out);
  }

  std::shared_ptr<void> create_request() override {return std::make_shared<Request>();}

  void handle_request(Header request_header, std::shared_ptr<void> request) override
  {
    if (const auto response =
      handler_(this, request_header, std::static_pointer_cast<Request>(std::move(request))))
    {
      send_response(*request_header, *response);
    }
  }

  void send_response(rmw_request_id_t & request_id, Response & response)
  {
    send_untyped(request_id, &response);
  }

private:
  Handler handler_;
};

namespace detail
{

/// One form for callbacks of all forms.
template<typename ServiceT, typename CallbackT>
typename Service<ServiceT>::Handler service_handler(CallbackT && callback)
{
  using Given = std::decay_t<CallbackT>;
  using Self = Service<ServiceT>;
  using Header = typename Self::Header;
  using Request = std::shared_ptr<typename ServiceT::Request>;
  using Response = std::shared_ptr<typename ServiceT::Response>;
  if constexpr (std::is_invocable_v<Given &, Request, Response>) {
    return [callback = Given(std::forward<CallbackT>(callback))](
      Self *, const Header &, const Request & request) mutable {
             auto response = std::make_shared<typename ServiceT::Response>();
             callback(request, response);
             return response;
           };
  } else if constexpr (std::is_invocable_v<Given &, Header, Request, Response>) {
    return [callback = Given(std::forward<CallbackT>(callback))](
      Self *, const Header & header, const Request & request) mutable {
             auto response = std::make_shared<typename ServiceT::Response>();
             callback(header, request, response);
             return response;
           };
  } else if constexpr (std::is_invocable_v<Given &, Header, Request>) {
    return [callback = Given(std::forward<CallbackT>(callback))](
      Self *, const Header & header, const Request & request) mutable {
             callback(header, request);
             return Response();
           };
  } else if constexpr (std::is_invocable_v<Given &, std::shared_ptr<Self>, Header, Request>) {
    return [callback = Given(std::forward<CallbackT>(callback))](
      Self * service, const Header & header, const Request & request) mutable {
             callback(service ? service->shared_from_this() : nullptr, header, request);
             return Response();
           };
  } else {
    static_assert(
      always_false<Given>,
      "the callback of a service takes shared pointers to the request and to the response");
  }
}

}  // namespace detail
}  // namespace rclcpp
