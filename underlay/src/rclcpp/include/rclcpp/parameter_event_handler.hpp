#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp
{

struct ParameterCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterCallbackHandle)
  using ParameterCallbackType = std::function<void (const Parameter &)>;

  std::string parameter_name;
  std::string node_name;
  ParameterCallbackType callback;
};

struct ParameterEventCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventCallbackHandle)
  using ParameterEventCallbackType = std::function<void (const rcl_interfaces::msg::ParameterEvent &)>;

  ParameterEventCallbackType callback;
};

/// Tells of changes of parameters, of one's own node and of others. Callbacks live as long as their handles.
class ParameterEventHandler
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventHandler)
  using ParameterEvent = rcl_interfaces::msg::ParameterEvent;
  using ParameterCallbackType = ParameterCallbackHandle::ParameterCallbackType;
  using ParameterEventCallbackType = ParameterEventCallbackHandle::ParameterEventCallbackType;

  template<typename NodeT>
  explicit ParameterEventHandler(NodeT node, const QoS & qos = ParameterEventsQoS())
  : callbacks_(std::make_shared<Callbacks>()),
    own_name_(node->get_fully_qualified_name()), own_namespace_(node->get_namespace())
  {
    subscription_ = node->template create_subscription<ParameterEvent>(
      "/parameter_events", qos,
      [callbacks = callbacks_](const ParameterEvent & event) {callbacks->event_callback(event);});
  }

  /// For one parameter, of `node_name` or, when that is empty, of one's own node.
  [[nodiscard]] ParameterCallbackHandle::SharedPtr add_parameter_callback(
    const std::string & parameter_name, ParameterCallbackType callback,
    const std::string & node_name = "");
  void remove_parameter_callback(ParameterCallbackHandle::SharedPtr callback_handle);

  /// For all changes of all nodes.
  [[nodiscard]] ParameterEventCallbackHandle::SharedPtr add_parameter_event_callback(
    ParameterEventCallbackType callback);
  void remove_parameter_event_callback(ParameterEventCallbackHandle::SharedPtr callback_handle);

  /// Whether the event has a new value of this parameter of this node; `parameter` is that then.
  static bool get_parameter_from_event(
    const ParameterEvent & event, Parameter & parameter, const std::string & parameter_name,
    const std::string & node_name = "");
  static Parameter get_parameter_from_event(
    const ParameterEvent & event, const std::string & parameter_name, const std::string & node_name = "");
  static std::vector<Parameter> get_parameters_from_event(const ParameterEvent & event);

protected:
  /// The names are those of the real one, for classes that derive from it.
  struct Callbacks
  {
    std::recursive_mutex mutex_;
    std::map<std::pair<std::string, std::string>, std::list<ParameterCallbackHandle::WeakPtr>>
    parameter_callbacks_;  // by the names of parameter and node
    std::list<ParameterEventCallbackHandle::WeakPtr> event_callbacks_;

    void event_callback(const ParameterEvent & event);
  };

  std::shared_ptr<Callbacks> callbacks_;

private:
  std::string full_name(const std::string & node_name) const;

  std::string own_name_, own_namespace_;
  Subscription<ParameterEvent>::SharedPtr subscription_;
};

}  // namespace rclcpp
