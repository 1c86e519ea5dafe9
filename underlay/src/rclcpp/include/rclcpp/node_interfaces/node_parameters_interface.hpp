#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rcl_interfaces/msg/detail/list_parameters_result__struct.hpp"
#include "rcl_interfaces/msg/detail/parameter_descriptor__struct.hpp"
#include "rcl_interfaces/msg/detail/parameter_event__struct.hpp"
#include "rcl_interfaces/msg/detail/set_parameters_result__struct.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/parameter.hpp"

namespace rclcpp::node_interfaces
{

/// Called before parameters are set; may change, add and remove.
struct PreSetParametersCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(PreSetParametersCallbackHandle)
  using PreSetParametersCallbackType = std::function<void (std::vector<Parameter> &)>;
  PreSetParametersCallbackType callback;
};

/// Called when parameters are to be set; says whether they are.
struct OnSetParametersCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(OnSetParametersCallbackHandle)
  using OnSetParametersCallbackType =
    std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<Parameter> &)>;
  using OnParametersSetCallbackType = OnSetParametersCallbackType;
  OnSetParametersCallbackType callback;
};

/// Called when parameters have been set.
struct PostSetParametersCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(PostSetParametersCallbackHandle)
  using PostSetParametersCallbackType = std::function<void (const std::vector<Parameter> &)>;
  PostSetParametersCallbackType callback;
};

/// The parameters of a node. Every method may be called from any thread, and from the callbacks unless it
/// changes something: then ParameterModifiedInCallbackException.
class NodeParametersInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeParametersInterface)
  RCLCPP_DISABLE_COPY(NodeParametersInterface)
  using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
  using Result = rcl_interfaces::msg::SetParametersResult;
  using Event = rcl_interfaces::msg::ParameterEvent;

  /// `changed` is given each change; it may be empty.
  NodeParametersInterface(
    std::map<std::string, ParameterValue> overrides, bool allow_undeclared,
    std::function<void(Event &)> changed);
  ~NodeParametersInterface();

  const ParameterValue & declare_parameter(
    const std::string & name, const ParameterValue & default_value,
    const Descriptor & parameter_descriptor = Descriptor(), bool ignore_override = false);
  const ParameterValue & declare_parameter(
    const std::string & name, ParameterType type,
    const Descriptor & parameter_descriptor = Descriptor(), bool ignore_override = false);
  void undeclare_parameter(const std::string & name);
  bool has_parameter(const std::string & name) const;

  std::vector<Result> set_parameters(const std::vector<Parameter> & parameters);
  Result set_parameters_atomically(const std::vector<Parameter> & parameters);

  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const;
  Parameter get_parameter(const std::string & name) const;
  bool get_parameter(const std::string & name, Parameter & parameter) const;
  bool get_parameters_by_prefix(
    const std::string & prefix, std::map<std::string, Parameter> & parameters) const;
  std::vector<Descriptor> describe_parameters(const std::vector<std::string> & names) const;
  std::vector<std::uint8_t> get_parameter_types(const std::vector<std::string> & names) const;
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, std::uint64_t depth) const;

  PreSetParametersCallbackHandle::SharedPtr add_pre_set_parameters_callback(
    PreSetParametersCallbackHandle::PreSetParametersCallbackType callback);
  OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(
    OnSetParametersCallbackHandle::OnSetParametersCallbackType callback);
  PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(
    PostSetParametersCallbackHandle::PostSetParametersCallbackType callback);
  void remove_pre_set_parameters_callback(const PreSetParametersCallbackHandle * handler);
  void remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * handler);
  void remove_post_set_parameters_callback(const PostSetParametersCallbackHandle * handler);

  const std::map<std::string, ParameterValue> & get_parameter_overrides() const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rclcpp::node_interfaces
