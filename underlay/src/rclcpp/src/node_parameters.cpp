#include <stdexcept>

#include "node_parameters_impl.hpp"

namespace rclcpp::node_interfaces
{

namespace
{

constexpr char separator = '.';

std::size_t depth_of(const std::string & name)
{
  return static_cast<std::size_t>(std::count(name.begin(), name.end(), separator));
}

/// Whether `name` is `prefix`, or below it by no more than `depth` steps; 0 is any number of them.
bool is_below(const std::string & name, const std::string & prefix, std::uint64_t depth)
{
  if (name == prefix) {
    return true;
  }
  const std::string start = prefix + separator;
  return name.rfind(start, 0) == 0 && (depth == 0 || depth_of(name.substr(start.size())) < depth);
}

bool is_listed(const std::string & name, const std::vector<std::string> & prefixes, std::uint64_t depth)
{
  if (prefixes.empty()) {
    return depth == 0 || depth_of(name) < depth;
  }
  return std::any_of(
    prefixes.begin(), prefixes.end(), [&](const auto & one) {return is_below(name, one, depth);});
}

}  // namespace

NodeParametersInterface::NodeParametersInterface(
  std::map<std::string, ParameterValue> overrides, bool allow_undeclared,
  std::function<void(Event &)> changed)
: impl_(std::make_unique<Impl>())
{
  impl_->overrides = std::move(overrides);
  impl_->allow_undeclared = allow_undeclared;
  impl_->changed = std::move(changed);
}

NodeParametersInterface::~NodeParametersInterface() = default;

const ParameterValue & NodeParametersInterface::declare_parameter(
  const std::string & name, const ParameterValue & default_value, const Descriptor & parameter_descriptor,
  bool ignore_override)
{
  const std::lock_guard lock(impl_->mutex);
  Descriptor descriptor = parameter_descriptor;
  if (!descriptor.dynamic_typing) {
    if (default_value.get_type() == PARAMETER_NOT_SET) {
      throw exceptions::InvalidParameterTypeException(
              name, "cannot declare a statically typed parameter with an uninitialized value");
    }
    descriptor.type = default_value.get_type();
  }
  return impl_->declare(name, default_value, std::move(descriptor), ignore_override);
}

const ParameterValue & NodeParametersInterface::declare_parameter(
  const std::string & name, ParameterType type, const Descriptor & parameter_descriptor,
  bool ignore_override)
{
  const std::lock_guard lock(impl_->mutex);
  if (type == PARAMETER_NOT_SET) {
    throw std::invalid_argument(
            "declare_parameter(): the provided parameter type cannot be rclcpp::PARAMETER_NOT_SET");
  }
  if (parameter_descriptor.dynamic_typing) {
    throw std::invalid_argument(
            "declare_parameter(): cannot declare parameter of specific type and pass descriptor "
            "with `dynamic_typing=true`");
  }
  Descriptor descriptor = parameter_descriptor;
  descriptor.type = type;
  return impl_->declare(name, ParameterValue(), std::move(descriptor), ignore_override);
}

void NodeParametersInterface::undeclare_parameter(const std::string & name)
{
  const std::lock_guard lock(impl_->mutex);
  impl_->may_be_changed();
  const auto found = impl_->entries.find(name);
  if (found == impl_->entries.end()) {
    throw exceptions::ParameterNotDeclaredException(
            "cannot undeclare parameter '" + name + "' which has not yet been declared");
  }
  if (found->second.descriptor.read_only) {
    throw exceptions::ParameterImmutableException(
            "cannot undeclare parameter '" + name + "' because it is read-only");
  }
  if (!found->second.descriptor.dynamic_typing) {
    throw exceptions::InvalidParameterTypeException(
            name, "cannot undeclare a statically typed parameter");
  }
  impl_->entries.erase(found);
}

bool NodeParametersInterface::has_parameter(const std::string & name) const
{
  const std::lock_guard lock(impl_->mutex);
  return impl_->entries.count(name) != 0;
}

std::vector<NodeParametersInterface::Result> NodeParametersInterface::set_parameters(
  const std::vector<Parameter> & parameters)
{
  std::vector<Result> results;
  for (const auto & parameter : parameters) {
    results.push_back(set_parameters_atomically({parameter}));
  }
  return results;
}

NodeParametersInterface::Result NodeParametersInterface::set_parameters_atomically(
  const std::vector<Parameter> & parameters)
{
  const std::lock_guard lock(impl_->mutex);
  return impl_->set(parameters);
}

std::vector<Parameter> NodeParametersInterface::get_parameters(
  const std::vector<std::string> & names) const
{
  const std::lock_guard lock(impl_->mutex);
  std::vector<Parameter> found;
  for (const auto & name : names) {
    found.push_back(get_parameter(name));
  }
  return found;
}

Parameter NodeParametersInterface::get_parameter(const std::string & name) const
{
  const std::lock_guard lock(impl_->mutex);
  const auto found = impl_->entries.find(name);
  if (found == impl_->entries.end()) {
    if (impl_->allow_undeclared) {
      return Parameter(name);
    }
    throw exceptions::ParameterNotDeclaredException(name);
  }
  const auto & [value, descriptor] = found->second;
  if (value.get_type() == PARAMETER_NOT_SET && !descriptor.dynamic_typing) {
    throw exceptions::ParameterUninitializedException(name);
  }
  return Parameter(name, value);
}

bool NodeParametersInterface::get_parameter(const std::string & name, Parameter & parameter) const
{
  const std::lock_guard lock(impl_->mutex);
  const auto found = impl_->entries.find(name);
  if (found == impl_->entries.end() || found->second.value.get_type() == PARAMETER_NOT_SET) {
    return false;
  }
  parameter = Parameter(name, found->second.value);
  return true;
}

bool NodeParametersInterface::get_parameters_by_prefix(
  const std::string & prefix, std::map<std::string, Parameter> & parameters) const
{
  const std::lock_guard lock(impl_->mutex);
  const std::string start = prefix.empty() ? prefix : prefix + separator;
  bool any = false;
  for (const auto & [name, known] : impl_->entries) {
    if (name.rfind(start, 0) == 0 && name.size() > start.size()) {
      parameters[name.substr(start.size())] = Parameter(name, known.value);
      any = true;
    }
  }
  return any;
}

std::vector<NodeParametersInterface::Descriptor> NodeParametersInterface::describe_parameters(
  const std::vector<std::string> & names) const
{
  const std::lock_guard lock(impl_->mutex);
  std::vector<Descriptor> found;
  for (const auto & name : names) {
    const auto known = impl_->entries.find(name);
    if (known != impl_->entries.end()) {
      found.push_back(known->second.descriptor);
    } else if (impl_->allow_undeclared) {
      found.emplace_back().name = name;
    } else {
      throw exceptions::ParameterNotDeclaredException(name);
    }
  }
  return found;
}

std::vector<std::uint8_t> NodeParametersInterface::get_parameter_types(
  const std::vector<std::string> & names) const
{
  const std::lock_guard lock(impl_->mutex);
  std::vector<std::uint8_t> types;
  for (const auto & name : names) {
    const auto known = impl_->entries.find(name);
    if (known == impl_->entries.end() && !impl_->allow_undeclared) {
      throw exceptions::ParameterNotDeclaredException(name);
    }
    types.push_back(
      known == impl_->entries.end() ? PARAMETER_NOT_SET : known->second.value.get_type());
  }
  return types;
}

rcl_interfaces::msg::ListParametersResult NodeParametersInterface::list_parameters(
  const std::vector<std::string> & prefixes, std::uint64_t depth) const
{
  const std::lock_guard lock(impl_->mutex);
  rcl_interfaces::msg::ListParametersResult result;
  for (const auto & [name, known] : impl_->entries) {
    if (!is_listed(name, prefixes, depth)) {
      continue;
    }
    result.names.push_back(name);
    const std::size_t last = name.rfind(separator);
    const std::string prefix = last == std::string::npos ? "" : name.substr(0, last);
    const auto & seen = result.prefixes;
    if (!prefix.empty() && std::find(seen.begin(), seen.end(), prefix) == seen.end()) {
      result.prefixes.push_back(prefix);
    }
  }
  return result;
}

PreSetParametersCallbackHandle::SharedPtr NodeParametersInterface::add_pre_set_parameters_callback(
  PreSetParametersCallbackHandle::PreSetParametersCallbackType callback)
{
  const std::lock_guard lock(impl_->mutex);
  impl_->may_be_changed();
  return impl_->pre_set.add(std::move(callback));
}

OnSetParametersCallbackHandle::SharedPtr NodeParametersInterface::add_on_set_parameters_callback(
  OnSetParametersCallbackHandle::OnSetParametersCallbackType callback)
{
  const std::lock_guard lock(impl_->mutex);
  impl_->may_be_changed();
  return impl_->on_set.add(std::move(callback));
}

PostSetParametersCallbackHandle::SharedPtr NodeParametersInterface::add_post_set_parameters_callback(
  PostSetParametersCallbackHandle::PostSetParametersCallbackType callback)
{
  const std::lock_guard lock(impl_->mutex);
  impl_->may_be_changed();
  return impl_->post_set.add(std::move(callback));
}

void NodeParametersInterface::remove_pre_set_parameters_callback(
  const PreSetParametersCallbackHandle * handler)
{
  const std::lock_guard lock(impl_->mutex);
  impl_->may_be_changed();
  impl_->pre_set.remove(handler);
}

void NodeParametersInterface::remove_on_set_parameters_callback(
  const OnSetParametersCallbackHandle * handler)
{
  const std::lock_guard lock(impl_->mutex);
  impl_->may_be_changed();
  impl_->on_set.remove(handler);
}

void NodeParametersInterface::remove_post_set_parameters_callback(
  const PostSetParametersCallbackHandle * handler)
{
  const std::lock_guard lock(impl_->mutex);
  impl_->may_be_changed();
  impl_->post_set.remove(handler);
}

const std::map<std::string, ParameterValue> & NodeParametersInterface::get_parameter_overrides() const
{
  return impl_->overrides;
}

}  // namespace rclcpp::node_interfaces
