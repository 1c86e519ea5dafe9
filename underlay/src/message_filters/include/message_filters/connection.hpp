#pragma once

#include <functional>
#include <utility>

namespace message_filters
{

/// A callback that is registered. It stays registered if this is lost.
class Connection
{
public:
  Connection() = default;
  explicit Connection(std::function<void()> end) : end_(std::move(end)) {}

  void disconnect()
  {
    if (end_) {
      end_();
    }
  }

private:
  std::function<void()> end_;
};

}  // namespace message_filters
