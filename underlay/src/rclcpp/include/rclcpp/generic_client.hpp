#pragma once

#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/client.hpp"

namespace rclcpp
{

/// A client of a service whose type is known by its name alone.
class GenericClient : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericClient)
  /// The request itself, and a response, both of the type that the name means.
  using Request = void *;
  using Response = void *;
  using SharedResponse = std::shared_ptr<void>;
  using Promise = std::promise<SharedResponse>;
  using SharedPromise = std::shared_ptr<Promise>;
  using Future = std::future<SharedResponse>;
  using SharedFuture = std::shared_future<SharedResponse>;

  struct FutureAndRequestId : detail::FutureAndRequestId<Future>
  {
    using detail::FutureAndRequestId<Future>::FutureAndRequestId;
    SharedFuture share() noexcept {return this->future.share();}
  };

  /// `service_type` as example_interfaces/srv/AddTwoInts. Throws std::runtime_error if there is no such type.
  GenericClient(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & service_name,
    const std::string & service_type, const QoS & qos);

  std::shared_ptr<void> create_response() override;

  /// Sends; the future is ready once the node has spun and the answer is there.
  FutureAndRequestId async_send_request(const Request request);

  /// Takes the next answer without an executor; false when there is none.
  bool take_response(Response response_out, rmw_request_id_t & request_header_out)
  {
    return take_type_erased_response(response_out, request_header_out);
  }

  template<typename AllocatorT = std::allocator<std::int64_t>>
  std::size_t prune_requests_older_than(
    std::chrono::system_clock::time_point time_point,
    std::vector<std::int64_t, AllocatorT> * pruned_requests = nullptr)
  {
    return prune_requests_older_than_time(time_point, pruned_requests);
  }

private:
  struct Type;

  GenericClient(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & service_name,
    std::shared_ptr<const Type> type, const QoS & qos);

  std::shared_ptr<const Type> type_;
};

}  // namespace rclcpp
