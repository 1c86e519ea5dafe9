#pragma once

#include <iostream>

// A number that prints what happens to it. The check uses a similar type that counts
// instead of printing.
class Noisy {
public:
  explicit Noisy(double value) : value_(value) {
    std::cout << "  made of " << value_ << '\n';
  }

  Noisy(const Noisy& other) : value_(other.value_) {
    std::cout << "  copied\n";
  }

  Noisy(Noisy&& other) noexcept : value_(other.value_) {
    std::cout << "  moved\n";
  }

  Noisy& operator=(const Noisy& other) = default;
  Noisy& operator=(Noisy&& other) noexcept = default;
  ~Noisy() = default;

  double value() const {
    return value_;
  }

private:
  double value_;
};
