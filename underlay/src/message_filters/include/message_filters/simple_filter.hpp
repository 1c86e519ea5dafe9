#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "message_filters/connection.hpp"
#include "message_filters/detail/signal.hpp"
#include "message_filters/message_event.hpp"

namespace message_filters
{

/// The output of a filter. Callbacks take the message, a pointer to it, or an event.
template<class M>
class SimpleFilter
{
public:
  using MConstPtr = std::shared_ptr<M const>;
  using Callback = std::function<void(const MConstPtr &)>;
  using EventType = MessageEvent<M const>;
  using EventCallback = std::function<void(const EventType &)>;

  SimpleFilter() = default;
  SimpleFilter(const SimpleFilter &) = delete;
  SimpleFilter & operator=(const SimpleFilter &) = delete;

  /// A function, anything that can be called, or a method and its object.
  template<typename ... Args>
  Connection registerCallback(Args && ... args)
  {
    return signal_.addCallback(std::forward<Args>(args)...);
  }

  void setName(const std::string & name) {name_ = name;}
  const std::string & getName() const {return name_;}

protected:
  void signalMessage(const MConstPtr & message) {signalMessage(EventType(message));}
  void signalMessage(const EventType & event) {signal_.call(event);}

private:
  detail::Signal<M> signal_;
  std::string name_;
};

}  // namespace message_filters
