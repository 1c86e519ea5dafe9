#include "rclcpp/parameter_event_handler.hpp"

#include <iterator>
#include <stdexcept>
#include <utility>

namespace rclcpp
{

namespace
{

template<typename Handle>
std::vector<std::shared_ptr<Handle>> still_there(std::list<std::weak_ptr<Handle>> & handles)
{
  handles.remove_if([](const auto & known) {return known.expired();});
  std::vector<std::shared_ptr<Handle>> found;
  for (const auto & known : handles) {
    if (auto handle = known.lock()) {  // its owner may let it go at any moment
      found.push_back(std::move(handle));
    }
  }
  return found;
}

template<typename Handle>
void take_out(std::list<std::weak_ptr<Handle>> & handles, const std::shared_ptr<Handle> & handle)
{
  const std::size_t before = handles.size();
  handles.remove_if([&](const auto & known) {return known.lock() == handle;});
  if (handles.size() == before) {
    throw std::runtime_error("Callback doesn't exist");
  }
}

}  // namespace

ParameterCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_callback(
  const std::string & parameter_name, ParameterCallbackType callback, const std::string & node_name)
{
  auto handle = std::make_shared<ParameterCallbackHandle>();
  handle->parameter_name = parameter_name;
  handle->node_name = full_name(node_name);
  handle->callback = std::move(callback);
  const std::lock_guard lock(callbacks_->mutex_);
  callbacks_->parameter_callbacks_[{parameter_name, handle->node_name}].emplace_front(handle);
  return handle;
}

void ParameterEventHandler::remove_parameter_callback(ParameterCallbackHandle::SharedPtr callback_handle)
{
  const std::lock_guard lock(callbacks_->mutex_);
  auto & known = callbacks_->parameter_callbacks_;
  const auto found = known.find({callback_handle->parameter_name, callback_handle->node_name});
  if (found == known.end()) {
    throw std::runtime_error("Callback doesn't exist");
  }
  take_out(found->second, callback_handle);
  if (found->second.empty()) {
    known.erase(found);
  }
}

ParameterEventCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_event_callback(
  ParameterEventCallbackType callback)
{
  auto handle = std::make_shared<ParameterEventCallbackHandle>();
  handle->callback = std::move(callback);
  const std::lock_guard lock(callbacks_->mutex_);
  callbacks_->event_callbacks_.emplace_front(handle);
  return handle;
}

void ParameterEventHandler::remove_parameter_event_callback(
  ParameterEventCallbackHandle::SharedPtr callback_handle)
{
  const std::lock_guard lock(callbacks_->mutex_);
  take_out(callbacks_->event_callbacks_, callback_handle);
}

bool ParameterEventHandler::get_parameter_from_event(
  const ParameterEvent & event, Parameter & parameter, const std::string & parameter_name,
  const std::string & node_name)
{
  if (event.node != node_name) {
    return false;
  }
  for (const auto * changes : {&event.new_parameters, &event.changed_parameters}) {
    for (const auto & message : *changes) {
      if (message.name == parameter_name) {
        parameter = Parameter::from_parameter_msg(message);
        return true;
      }
    }
  }
  return false;
}

Parameter ParameterEventHandler::get_parameter_from_event(
  const ParameterEvent & event, const std::string & parameter_name, const std::string & node_name)
{
  Parameter parameter;
  if (event.node != node_name) {
    throw std::runtime_error(
            "The node name '" + node_name + "' of parameter '" + parameter_name +
            "' doesn't match the node name '" + event.node + "' in parameter event");
  }
  const bool is_part = get_parameter_from_event(event, parameter, parameter_name, node_name);
  return is_part ? parameter : Parameter(parameter_name, PARAMETER_NOT_SET);
}

std::vector<Parameter> ParameterEventHandler::get_parameters_from_event(const ParameterEvent & event)
{
  std::vector<Parameter> parameters;
  for (const auto * changes : {&event.new_parameters, &event.changed_parameters}) {
    for (const auto & message : *changes) {
      parameters.push_back(Parameter::from_parameter_msg(message));
    }
  }
  return parameters;
}

void ParameterEventHandler::Callbacks::event_callback(const ParameterEvent & event)
{
  const std::lock_guard lock(mutex_);
  std::vector<std::pair<ParameterCallbackHandle::SharedPtr, Parameter>> told;
  for (auto known = parameter_callbacks_.begin(); known != parameter_callbacks_.end(); ) {
    const auto handles = still_there(known->second);
    const auto & [parameter_name, node_name] = known->first;
    Parameter parameter;
    if (get_parameter_from_event(event, parameter, parameter_name, node_name)) {
      for (const auto & handle : handles) {
        told.emplace_back(handle, parameter);
      }
    }
    known = handles.empty() ? parameter_callbacks_.erase(known) : std::next(known);
  }
  const auto event_handles = still_there(event_callbacks_);
  for (const auto & [handle, parameter] : told) {
    handle->callback(parameter);
  }
  for (const auto & handle : event_handles) {
    handle->callback(event);
  }
}

std::string ParameterEventHandler::full_name(const std::string & node_name) const
{
  if (node_name.empty()) {
    return own_name_;
  }
  if (node_name.front() == '/') {
    return node_name;
  }
  return own_namespace_ == "/" ? "/" + node_name : own_namespace_ + "/" + node_name;
}

}  // namespace rclcpp
