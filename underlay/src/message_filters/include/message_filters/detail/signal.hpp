#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

#include "message_filters/connection.hpp"
#include "message_filters/message_event.hpp"

namespace message_filters::detail
{

/// What a callback is given that takes a `P`, which is a message, a pointer to one, or an event.
template<typename P>
struct Given
{
  template<typename M>
  static const M & from(const MessageEvent<M const> & event, bool)
  {
    return *event.getConstMessage();
  }
};
template<typename P>
struct Given<MessageEvent<P>>
{
  template<typename M>
  static MessageEvent<P> from(const MessageEvent<M const> & event, bool is_shared)
  {
    return MessageEvent<P>(event, is_shared || event.nonConstWillCopy());
  }
};
template<typename P>
struct Given<std::shared_ptr<P>>
{
  template<typename M>
  static std::shared_ptr<P> from(const MessageEvent<M const> & event, bool is_shared)
  {
    return Given<MessageEvent<P>>::from(event, is_shared).getMessage();
  }
};

/// Calls everybody who has registered a callback for messages of these types.
template<typename ... Ms>
class Signal
{
public:
  template<typename ... Ps>
  Connection addCallback(void (* callback)(Ps...))
  {
    return add_typed(std::function<void(Ps...)>(callback));
  }
  template<typename ... Ps>
  Connection addCallback(const std::function<void(Ps...)> & callback)
  {
    return add_typed(callback);
  }
  template<typename T, typename U, typename ... Ps>
  Connection addCallback(void (T::* callback)(Ps...), U * object)
  {
    return add_typed(
      std::function<void(Ps...)>(
        [callback, object](Ps... given) {(object->*callback)(std::forward<Ps>(given)...);}));
  }
  /// Anything else that can be called with pointers, such as what std::bind returns.
  template<typename C>
  Connection addCallback(const C & callback)
  {
    return add(
      [callback](bool, const MessageEvent<Ms const> &... events) mutable {
        callback(events.getConstMessage()...);
      });
  }

  void call(const MessageEvent<Ms const> &... events) const
  {
    const std::lock_guard lock(list_->mutex);
    const auto callbacks = list_->callbacks;  // a callback may remove itself
    for (const auto & callback : callbacks) {
      (*callback)(callbacks.size() > 1, events...);
    }
  }

private:
  using Callback = std::function<void(bool, const MessageEvent<Ms const> &...)>;
  struct List
  {
    /// Held during calls: nobody is called after being disconnected.
    std::recursive_mutex mutex;
    std::vector<std::shared_ptr<Callback>> callbacks;
  };

  template<typename ... Ps>
  Connection add_typed(const std::function<void(Ps...)> & callback)
  {
    static_assert(sizeof...(Ps) == sizeof...(Ms), "the callback must take one argument for each message");
    return add(
      [callback](bool is_shared, const MessageEvent<Ms const> &... events) {
        callback(Given<std::decay_t<Ps>>::from(events, is_shared)...);
      });
  }

  Connection add(Callback given)
  {
    const auto callback = std::make_shared<Callback>(std::move(given));
    const std::lock_guard lock(list_->mutex);
    list_->callbacks.push_back(callback);
    return Connection(
      [weak = std::weak_ptr<List>(list_), callback] {
        if (const auto list = weak.lock()) {
          const std::lock_guard disconnecting(list->mutex);
          auto & all = list->callbacks;
          all.erase(std::remove(all.begin(), all.end(), callback), all.end());
        }
      });
  }

  const std::shared_ptr<List> list_ = std::make_shared<List>();
};

}  // namespace message_filters::detail
