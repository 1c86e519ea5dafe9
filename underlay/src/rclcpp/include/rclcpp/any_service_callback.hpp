#pragma once

#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "rclcpp/service.hpp"

namespace rclcpp
{

/// A callback of a service, in any of its forms.
template<typename ServiceT>
class AnyServiceCallback
{
public:
  using Request = std::shared_ptr<typename ServiceT::Request>;
  using Response = std::shared_ptr<typename ServiceT::Response>;

  /// Throws std::invalid_argument for an empty one.
  template<typename CallbackT>
  void set(CallbackT && callback)
  {
    if constexpr (std::is_constructible_v<bool, std::decay_t<CallbackT>>) {
      if (!static_cast<bool>(callback)) {
        throw std::invalid_argument("AnyServiceCallback::set(): callback cannot be nullptr");
      }
    }
    handler_ = detail::service_handler<ServiceT>(std::forward<CallbackT>(callback));
  }

  /// Gives the response, or nothing if that is sent later. Throws std::runtime_error if none is set.
  Response dispatch(
    const std::shared_ptr<Service<ServiceT>> & service_handle,
    const std::shared_ptr<rmw_request_id_t> & request_header, Request request)
  {
    if (!handler_) {
      throw std::runtime_error("unexpected request without any callback set");
    }
    return handler_(service_handle.get(), request_header, request);
  }

private:
  typename Service<ServiceT>::Handler handler_;
};

}  // namespace rclcpp
