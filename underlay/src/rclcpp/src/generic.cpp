#include <dlfcn.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include "rclcpp/detail/check.hpp"
#include "rclcpp/generic_client.hpp"
#include "rclcpp/generic_publisher.hpp"
#include "rclcpp/generic_subscription.hpp"
#include "rclcpp/serialization.hpp"
#include "rclcpp/typesupport_helpers.hpp"
#include "rosidl_typesupport_introspection_cpp/message_introspection.hpp"
#include "rosidl_typesupport_introspection_cpp/service_introspection.hpp"

namespace rclcpp
{

namespace introspection = rosidl_typesupport_introspection_cpp;

namespace
{

/// The same, with a library that stays loaded: the middleware remembers types.
template<typename HandleT>
const HandleT & pinned(rcpputils::SharedLibrary & library, const HandleT & handle)
{
  dlopen(library.get_library_path().c_str(), RTLD_LAZY | RTLD_NODELETE);
  return handle;
}

const rosidl_message_type_support_t & load_type(const std::string & name)
{
  const std::string identifier = "rosidl_typesupport_cpp";
  const auto library = get_typesupport_library(name, identifier);
  return pinned(*library, *get_message_typesupport_handle(name, identifier, *library));
}

}  // namespace

GenericPublisher::GenericPublisher(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
  const std::string & topic_type, const QoS & qos, const PublisherOptionsBase & options)
: GenericPublisher(node, topic, load_type(topic_type), qos, options)
{
}

GenericPublisher::GenericPublisher(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
  const rosidl_message_type_support_t & type_support, const QoS & qos,
  const PublisherOptionsBase & options)
: PublisherBase(node, topic, type_support, qos, options), type_support_(type_support)
{
}

void GenericPublisher::publish(const SerializedMessage & message)
{
  publish_serialized(message.get_rcl_serialized_message());
}

void GenericPublisher::publish_as_loaned_msg(const SerializedMessage & message)
{
  void * loaned = nullptr;
  auto & handle = *get_publisher_handle();
  detail::check(
    rcl_borrow_loaned_message(&handle, &type_support_, &loaned), "failed to borrow loaned msg");
  try {
    SerializationBase(&type_support_).deserialize_message(&message, loaned);
  } catch (...) {
    if (rcl_return_loaned_message_from_publisher(&handle, loaned) != RCL_RET_OK) {
      rcl_reset_error();
    }
    throw;
  }
  detail::check(rcl_publish_loaned_message(&handle, loaned, nullptr), "failed to publish message");
}

GenericSubscription::GenericSubscription(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
  const std::string & topic_type, const QoS & qos, detail::MessageHandler<SerializedMessage> handler,
  const SubscriptionOptionsBase & options)
: SubscriptionBase(node, topic, load_type(topic_type), qos, options, Form::bytes),
  handler_(std::move(handler))
{
}

std::shared_ptr<void> GenericSubscription::create_message()
{
  throw exceptions::UnimplementedError("a generic subscription has serialized messages only");
}

void GenericSubscription::handle_message(std::shared_ptr<void> &, const MessageInfo &)
{
  throw exceptions::UnimplementedError("a generic subscription has serialized messages only");
}

void GenericSubscription::handle_serialized_message(
  const std::shared_ptr<SerializedMessage> & message, const MessageInfo & message_info)
{
  handler_(std::shared_ptr<SerializedMessage>(message), message_info);
}

/// What is known about responses, so that they can be made.
struct GenericClient::Type
{
  explicit Type(const std::string & name)
  : library(get_typesupport_library(name, service_typesupport)),
    introspection(get_typesupport_library(name, introspection_typesupport)),
    service(*get_service_typesupport_handle(name, service_typesupport, *library))
  {
    const auto * handle =
      get_service_typesupport_handle(name, introspection_typesupport, *introspection);
    response = static_cast<const introspection::ServiceMembers *>(handle->data)->response_members_;
  }

  static constexpr auto service_typesupport = "rosidl_typesupport_cpp";
  static constexpr auto introspection_typesupport = "rosidl_typesupport_introspection_cpp";
  std::shared_ptr<rcpputils::SharedLibrary> library, introspection;
  const rosidl_service_type_support_t & service;
  const introspection::MessageMembers * response;
};

GenericClient::GenericClient(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & service_name,
  const std::string & service_type, const QoS & qos)
: GenericClient(node, service_name, std::make_shared<const Type>(service_type), qos)
{
}

GenericClient::GenericClient(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & service_name,
  std::shared_ptr<const Type> type, const QoS & qos)
: ClientBase(node, service_name, pinned(*type->library, type->service), qos), type_(std::move(type))
{
}

std::shared_ptr<void> GenericClient::create_response()
{
  const auto * members = type_->response;
  void * const response = ::operator new(members->size_of_);
  members->init_function(response, rosidl_runtime_cpp::MessageInitialization::ZERO);
  return {response, [type = type_](void * gone) {
      type->response->fini_function(gone);
      ::operator delete(gone);
    }};
}

GenericClient::FutureAndRequestId GenericClient::async_send_request(const Request request)
{
  const auto promise = std::make_shared<Promise>();
  auto future = promise->get_future();
  const auto id = send_untyped(
    request, [promise](std::shared_ptr<void> response) {promise->set_value(std::move(response));});
  return FutureAndRequestId(std::move(future), id);
}

}  // namespace rclcpp
