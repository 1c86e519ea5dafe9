#pragma once

#include <algorithm>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/node_interfaces/node_parameters_interface.hpp"

namespace rclcpp::node_interfaces
{

/// Callbacks that live as long as their handles.
template<typename HandleT>
class Callbacks
{
public:
  template<typename CallbackT>
  std::shared_ptr<HandleT> add(CallbackT && callback)
  {
    auto handle = std::make_shared<HandleT>();
    handle->callback = std::forward<CallbackT>(callback);
    // The latest comes first.
    handles_.emplace_front(handle);
    return handle;
  }

  void remove(const HandleT * handle)
  {
    const auto found = std::find_if(
      handles_.begin(), handles_.end(), [&](const auto & known) {return known.lock().get() == handle;});
    if (found == handles_.end()) {
      throw std::runtime_error("Callback doesn't exist");
    }
    handles_.erase(found);
  }

  std::vector<std::shared_ptr<HandleT>> alive()
  {
    std::vector<std::shared_ptr<HandleT>> found;
    handles_.remove_if([](const auto & known) {return known.expired();});
    for (const auto & known : handles_) {
      if (auto handle = known.lock()) {  // its owner may let it go at any moment
        found.push_back(std::move(handle));
      }
    }
    return found;
  }

private:
  std::list<std::weak_ptr<HandleT>> handles_;
};

struct NodeParametersInterface::Impl
{
  struct Entry
  {
    ParameterValue value;
    Descriptor descriptor;
  };

  /// Forbids changes while callbacks run.
  class Calling
  {
public:
    explicit Calling(Impl & impl) : impl_(impl) {impl_.is_calling = true;}
    Calling(const Calling &) = delete;
    Calling & operator=(const Calling &) = delete;
    ~Calling() {impl_.is_calling = false;}

private:
    Impl & impl_;
  };

  std::recursive_mutex mutex;
  std::map<std::string, Entry> entries;
  std::map<std::string, ParameterValue> overrides;
  bool allow_undeclared = false;
  std::function<void(Event &)> changed;
  bool is_calling = false;
  Callbacks<PreSetParametersCallbackHandle> pre_set;
  Callbacks<OnSetParametersCallbackHandle> on_set;
  Callbacks<PostSetParametersCallbackHandle> post_set;

  // All of these are called with the mutex held.
  void may_be_changed() const;
  Entry & entry(const std::string & name);
  Result checked(const std::vector<Parameter> & parameters);
  Result asked(const std::vector<Parameter> & parameters);
  void told(const std::vector<Parameter> & parameters);
  void publish(Event & event) const;
  const ParameterValue & declare(
    const std::string & name, const ParameterValue & value, Descriptor descriptor, bool ignore_override);
  Result begin(const Parameter & parameter);
  Result set(std::vector<Parameter> parameters);
  void store(const std::vector<Parameter> & parameters, Event & event);
  std::vector<std::string> implicit(const std::vector<Parameter> & parameters) const;
};

}  // namespace rclcpp::node_interfaces
