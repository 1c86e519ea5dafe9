#pragma once

#include "message_filters/simple_filter.hpp"

namespace message_filters
{

/// Passes on what it is given.
template<typename M>
class PassThrough : public SimpleFilter<M>
{
public:
  using typename SimpleFilter<M>::MConstPtr;
  using typename SimpleFilter<M>::EventType;

  PassThrough() = default;
  template<typename F>
  explicit PassThrough(F & input)
  {
    connectInput(input);
  }
  ~PassThrough() {input_.disconnect();}

  template<class F>
  void connectInput(F & input)
  {
    input_.disconnect();
    input_ = input.registerCallback(
      typename SimpleFilter<M>::EventCallback([this](const EventType & event) {add(event);}));
  }
  void add(const MConstPtr & message) {add(EventType(message));}
  void add(const EventType & event) {this->signalMessage(event);}

private:
  Connection input_;
};

}  // namespace message_filters
