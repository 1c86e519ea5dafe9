#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>

#include "message_filters/connection.hpp"
#include "message_filters/detail/signal.hpp"
#include "message_filters/message_event.hpp"
#include "message_filters/message_traits.hpp"

namespace message_filters
{

/// The base of policies, which decide what messages belong together. Copies have no callbacks.
template<typename ... Ms>
class PolicyBase
{
public:
  static_assert(sizeof...(Ms) >= 2 && sizeof...(Ms) <= 9, "2 to 9 messages can be synchronized");
  using Messages = std::tuple<Ms...>;
  using Events = std::tuple<MessageEvent<Ms const>...>;

  /// A function, anything that can be called, or a method and its object. It takes one message of each kind.
  template<typename ... Args>
  Connection registerCallback(Args && ... args)
  {
    return signal_.addCallback(std::forward<Args>(args)...);
  }

protected:
  using Signal = detail::Signal<Ms...>;
  template<std::size_t i>
  using Event = std::tuple_element_t<i, Events>;

  PolicyBase() = default;
  PolicyBase(const PolicyBase &) {}

  static void call(const Signal & signal, const Events & events)
  {
    std::apply([&signal](const auto & ... each) {signal.call(each ...);}, events);
  }
  template<std::size_t i>
  static std::int64_t time_of(const Event<i> & event)
  {
    using M = std::tuple_element_t<i, Messages>;
    return message_traits::TimeStamp<M>::value(*event.getConstMessage()).nanoseconds();
  }

  Signal signal_;
  /// Callbacks are called under it, and may add messages.
  std::recursive_mutex mutex_;
};

/// Brings messages of several inputs together.
template<class Policy>
class Synchronizer : public Policy
{
public:
  using typename Policy::Events;
  using typename Policy::Messages;
  static constexpr std::size_t COUNT = std::tuple_size_v<Messages>;

  Synchronizer(const Policy & policy)  // NOLINT: as the real one has it
  : Policy(policy)
  {
  }
  template<class ... Fs, typename = std::enable_if_t<sizeof...(Fs) != 0>>
  explicit Synchronizer(const Policy & policy, Fs & ... inputs)
  : Policy(policy)
  {
    connectInput(inputs ...);
  }
  Synchronizer(const Synchronizer &) = delete;
  Synchronizer & operator=(const Synchronizer &) = delete;
  ~Synchronizer() {disconnect();}

  template<class ... Fs>
  void connectInput(Fs & ... inputs)
  {
    static_assert(sizeof...(Fs) == COUNT, "there must be one input for each kind of message");
    disconnect();
    connect(std::make_index_sequence<COUNT>(), inputs ...);
  }

  using Policy::add;
  template<int i>
  void add(const std::shared_ptr<std::tuple_element_t<i, Messages> const> & message)
  {
    this->template add<i>(std::tuple_element_t<i, Events>(message));
  }

  void setName(const std::string & name) {name_ = name;}
  const std::string & getName() const {return name_;}
  Policy * getPolicy() {return this;}

private:
  template<std::size_t ... is, class ... Fs>
  void connect(std::index_sequence<is...>, Fs & ... inputs)
  {
    ((connections_[is] = inputs.registerCallback(
      std::function<void(const std::tuple_element_t<is, Events> &)>(
        [this](const std::tuple_element_t<is, Events> & event) {this->template add<is>(event);}))), ...);
  }
  void disconnect()
  {
    for (auto & connection : connections_) {
      connection.disconnect();
    }
  }

  std::array<Connection, COUNT> connections_;
  std::string name_;
};

}  // namespace message_filters
