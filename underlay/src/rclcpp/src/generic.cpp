#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "rclcpp/detail/check.hpp"
#include "rclcpp/detail/loaded_type.hpp"
#include "rclcpp/generic_publisher.hpp"
#include "rclcpp/generic_subscription.hpp"

namespace rclcpp
{

namespace
{

/// The package, the kind and the name of a type: {std_msgs, msg, String}, also for std_msgs/String.
std::array<std::string, 3> parts_of(const std::string & name)
{
  const auto first = name.find('/'), last = name.rfind('/');
  if (first == std::string::npos || first == 0 || last + 1 == name.size()) {
    throw std::runtime_error("Message type is not of the form package/type and cannot be processed");
  }
  const bool has_kind = first != last;
  return {
    name.substr(0, first), has_kind ? name.substr(first + 1, last - first - 1) : "msg",
    name.substr(last + 1)};
}

/// A symbol of a library, which stays loaded; nothing when either is not there.
void * find_symbol(const std::string & library, const std::string & symbol)
{
  const std::unique_ptr<void, int (*)(void *)> loaded(
    dlopen(library.c_str(), RTLD_LAZY | RTLD_NODELETE), dlclose);
  return loaded ? dlsym(loaded.get(), symbol.c_str()) : nullptr;
}

/// Where the library of a package may be; the name alone leaves it to the loader.
std::vector<std::string> places_of(const std::string & library)
{
  std::vector<std::string> places;
  const char * prefixes = std::getenv("AMENT_PREFIX_PATH");
  std::istringstream rest(prefixes ? prefixes : "");
  for (std::string prefix; std::getline(rest, prefix, ':'); ) {
    places.push_back(prefix + "/lib/" + library);
  }
  places.push_back(library);
  return places;
}

}  // namespace

const rosidl_message_type_support_t & detail::load_type(const std::string & name)
{
  const auto [package, kind, type] = parts_of(name);
  const std::string symbol =
    "rosidl_typesupport_cpp__get_message_type_support_handle__" + package + "__" + kind + "__" + type;
  for (const auto & place : places_of("lib" + package + "__rosidl_typesupport_cpp.so")) {
    if (void * found = find_symbol(place, symbol)) {
      return *reinterpret_cast<const rosidl_message_type_support_t * (*)()>(found)();
    }
  }
  throw std::runtime_error(
          "Something went wrong loading the typesupport library for message type " + name +
          ". Is the package '" + package + "' installed and sourced, and does it have this type?");
}

GenericPublisher::GenericPublisher(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
  const std::string & topic_type, const QoS & qos, const PublisherOptionsBase & options)
: PublisherBase(node, topic, detail::load_type(topic_type), qos, options)
{
}

void GenericPublisher::publish(const SerializedMessage & message)
{
  publish_serialized(message.get_rcl_serialized_message());
}

GenericSubscription::GenericSubscription(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
  const std::string & topic_type, const QoS & qos, detail::MessageHandler<SerializedMessage> handler,
  const SubscriptionOptionsBase & options)
: SubscriptionBase(node, topic, detail::load_type(topic_type), qos, options, Form::bytes),
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

}  // namespace rclcpp
