// One place that says whether a program is to end.

#pragma once

#include <atomic>

namespace sas
{

/// For any number of threads: all who hold it may ask, or end the program for all who ask.
class ShutdownSignaler
{
public:
  ShutdownSignaler() = default;

  /// The program is to end when `*external_shutdown_signal` is true, too; shutdown() sets it.
  ShutdownSignaler(std::atomic_bool * external_shutdown_signal)  // NOLINT: it stands for one
  : signal_(external_shutdown_signal ? external_shutdown_signal : &own_signal_) {}
  ShutdownSignaler(const ShutdownSignaler &) = delete;
  ShutdownSignaler & operator=(const ShutdownSignaler &) = delete;

  bool should_shutdown() const {return *signal_;}
  void shutdown() {*signal_ = true;}

  /// For code that looks at a flag.
  std::atomic_bool * flag() {return signal_;}

private:
  std::atomic_bool own_signal_{false};
  std::atomic_bool * signal_ = &own_signal_;
};

}  // namespace sas
