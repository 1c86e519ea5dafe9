#include "node_parameters_impl.hpp"
#include "parameter_checks.hpp"

namespace rclcpp::node_interfaces
{

namespace
{

using Result = NodeParametersInterface::Result;

Result refused(const std::string & reason)
{
  Result result;
  result.successful = false;
  result.reason = reason;
  return result;
}

/// Whether setting a parameter takes away the value that it has, and the parameter with it.
bool is_undeclared_by(const Parameter & parameter, const ParameterValue & value)
{
  return parameter.get_type() == PARAMETER_NOT_SET && value.get_type() != PARAMETER_NOT_SET;
}

}  // namespace

void NodeParametersInterface::Impl::may_be_changed() const
{
  if (is_calling) {
    throw exceptions::ParameterModifiedInCallbackException(
            "cannot set or declare a parameter, or change the callback from within set callback");
  }
}

NodeParametersInterface::Impl::Entry & NodeParametersInterface::Impl::entry(const std::string & name)
{
  const auto found = entries.find(name);
  if (found == entries.end()) {
    throw exceptions::ParameterNotDeclaredException(
            "parameter '" + name + "' cannot be set because it was not declared");
  }
  return found->second;
}

/// Whether descriptors allow it.
Result NodeParametersInterface::Impl::checked(const std::vector<Parameter> & parameters)
{
  for (const auto & parameter : parameters) {
    const auto & [value, descriptor] = entry(parameter.get_name());
    if (is_undeclared_by(parameter, value) && !descriptor.dynamic_typing) {
      return refused("cannot undeclare a statically typed parameter");
    }
    const Result result = detail::check_parameter(parameter, descriptor);
    if (!result.successful) {
      return result;
    }
  }
  Result result;
  result.successful = true;
  return result;
}

/// Whether the user's callbacks allow it.
Result NodeParametersInterface::Impl::asked(const std::vector<Parameter> & parameters)
{
  const Calling calling(*this);
  Result result;
  result.successful = true;
  for (const auto & handle : on_set.alive()) {
    result = handle->callback(parameters);
    if (!result.successful) {
      break;
    }
  }
  return result;
}

void NodeParametersInterface::Impl::told(const std::vector<Parameter> & parameters)
{
  for (const auto & handle : post_set.alive()) {
    handle->callback(parameters);
  }
}

void NodeParametersInterface::Impl::publish(Event & event) const
{
  if (changed) {
    changed(event);
  }
}

/// Those that come to be by being set.
std::vector<std::string> NodeParametersInterface::Impl::implicit(
  const std::vector<Parameter> & parameters) const
{
  std::vector<std::string> names;
  for (const auto & parameter : parameters) {
    if (entries.count(parameter.get_name()) != 0) {
      continue;
    }
    if (!allow_undeclared) {
      throw exceptions::ParameterNotDeclaredException(
              "parameter '" + parameter.get_name() + "' cannot be set because it was not declared");
    }
    names.push_back(parameter.get_name());
  }
  return names;
}

void NodeParametersInterface::Impl::store(const std::vector<Parameter> & parameters, Event & event)
{
  for (const auto & parameter : parameters) {
    const std::string & name = parameter.get_name();
    auto & known = entry(name);
    if (is_undeclared_by(parameter, known.value)) {
      const Parameter last(name, known.value);
      event.deleted_parameters.push_back(last.to_parameter_msg());
      entries.erase(name);
    } else {
      const bool is_new =
        known.value.get_type() == PARAMETER_NOT_SET && parameter.get_type() != PARAMETER_NOT_SET;
      known.value = parameter.get_parameter_value();
      known.descriptor.type = parameter.get_type();
      (is_new ? event.new_parameters : event.changed_parameters).push_back(parameter.to_parameter_msg());
    }
  }
}

Result NodeParametersInterface::Impl::set(std::vector<Parameter> parameters)
{
  may_be_changed();
  const bool was_empty = parameters.empty();
  {
    const Calling calling(*this);
    for (const auto & handle : pre_set.alive()) {
      handle->callback(parameters);
    }
  }
  if (!was_empty && parameters.empty()) {
    return refused(
      "parameter list cannot be empty, this might be due to "
      "pre_set_parameters_callback modifying the original parameters list.");
  }
  const auto fresh = implicit(parameters);
  for (const auto & parameter : parameters) {
    const auto found = entries.find(parameter.get_name());
    if (found != entries.end() && found->second.descriptor.read_only) {
      return refused(
        "parameter '" + parameter.get_name() + "' cannot be set because it is read-only");
    }
  }
  for (const auto & name : fresh) {
    entries[name].descriptor.name = name;
    entries[name].descriptor.dynamic_typing = true;
  }
  Result result = checked(parameters);
  if (result.successful) {
    result = asked(parameters);
  }
  if (!result.successful) {
    for (const auto & name : fresh) {
      entries.erase(name);
    }
    return result;
  }
  Event event;
  store(parameters, event);
  told(parameters);
  publish(event);
  return result;
}

/// Gives a new parameter its first value; its entry is there and has none.
Result NodeParametersInterface::Impl::begin(const Parameter & parameter)
{
  std::vector<Parameter> parameters{parameter};
  {
    const Calling calling(*this);
    for (const auto & handle : pre_set.alive()) {
      handle->callback(parameters);
    }
  }
  Result result = checked(parameters);
  if (result.successful) {
    result = asked(parameters);
  }
  if (result.successful) {
    Event event;
    store(parameters, event);
    told(parameters);
    publish(event);
  }
  return result;
}

const ParameterValue & NodeParametersInterface::Impl::declare(
  const std::string & name, const ParameterValue & value, Descriptor descriptor, bool ignore_override)
{
  may_be_changed();
  if (name.empty()) {
    throw exceptions::InvalidParametersException("parameter name must not be empty");
  }
  if (entries.count(name) != 0) {
    throw exceptions::ParameterAlreadyDeclaredException(
            "parameter '" + name + "' has already been declared");
  }
  const auto given = overrides.find(name);
  const bool is_overridden = !ignore_override && given != overrides.end();
  const Parameter initial(name, is_overridden ? given->second : value);
  descriptor.name = name;
  entries[name].descriptor = std::move(descriptor);
  if (initial.get_type() == PARAMETER_NOT_SET) {
    return entries[name].value;
  }
  Result result;
  try {
    result = begin(initial);
  } catch (...) {
    entries.erase(name);  // a callback of the user's
    throw;
  }
  if (result.successful) {
    return entries[name].value;
  }
  entries.erase(name);
  if (result.reason.rfind(detail::wrong_type, 0) == 0) {
    throw exceptions::InvalidParameterTypeException(name, result.reason);
  }
  throw exceptions::InvalidParameterValueException(
          "parameter '" + name + "' could not be set: " + result.reason);
}

}  // namespace rclcpp::node_interfaces
