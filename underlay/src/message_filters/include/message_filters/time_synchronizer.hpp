#pragma once

#include <cstdint>
#include <tuple>
#include <utility>

#include "message_filters/sync_policies/exact_time.hpp"
#include "message_filters/synchronizer.hpp"

namespace message_filters
{

/// Brings messages with the same time together.
template<class M0, class M1, class ... Ms>
class TimeSynchronizer : public Synchronizer<sync_policies::ExactTime<M0, M1, Ms...>>
{
public:
  using Policy = sync_policies::ExactTime<M0, M1, Ms...>;
  using Base = Synchronizer<Policy>;

  explicit TimeSynchronizer(std::uint32_t queue_size)
  : Base(Policy(queue_size))
  {
  }
  /// The inputs, and the size of the queue.
  template<class F0, class F1, class ... Rest>
  TimeSynchronizer(F0 & input0, F1 & input1, Rest && ... rest)
  : Base(Policy(static_cast<std::uint32_t>(std::get<sizeof...(Rest) - 1>(std::tie(rest ...)))))
  {
    connect(std::make_index_sequence<sizeof...(Rest) - 1>(), input0, input1, std::tie(rest ...));
  }

private:
  template<std::size_t ... is, class F0, class F1, class Rest>
  void connect(std::index_sequence<is...>, F0 & input0, F1 & input1, const Rest & rest)
  {
    this->connectInput(input0, input1, std::get<is>(rest) ...);
  }
};

}  // namespace message_filters
