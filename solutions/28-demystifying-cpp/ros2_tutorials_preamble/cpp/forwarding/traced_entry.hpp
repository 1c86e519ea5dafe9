#pragma once

#include <iostream>

// An entry of the trip log: how far the rover drove, in meters. It prints what happens to it.
// The check uses a similar type that counts instead of printing.
class TracedEntry {
public:
  explicit TracedEntry(double value) : value_(value) {
    std::cout << "  made of " << value_ << '\n';
  }

  TracedEntry(const TracedEntry& other) : value_(other.value_) {
    std::cout << "  copied\n";
  }

  TracedEntry(TracedEntry&& other) noexcept : value_(other.value_) {
    std::cout << "  moved\n";
  }

  TracedEntry& operator=(const TracedEntry& other) = default;
  TracedEntry& operator=(TracedEntry&& other) noexcept = default;
  ~TracedEntry() = default;

  double value() const {
    return value_;
  }

private:
  double value_;
};
