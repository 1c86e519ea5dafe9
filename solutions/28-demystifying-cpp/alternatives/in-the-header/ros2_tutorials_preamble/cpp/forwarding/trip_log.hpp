#pragma once

#include <memory>
#include <utility>
#include <vector>

template <typename Entry, typename... Arguments>
std::shared_ptr<Entry> make(Arguments... arguments) {
  std::allocator<Entry> everyday;
  return std::allocate_shared<Entry>(everyday, std::move(arguments)...);
}

template <typename Entry>
void append(std::vector<Entry>& entries, double value) {
  auto& made = entries.emplace_back(std::move(value));
  static_cast<void>(made);
}

template <typename Entries>
double total(Entries&& entries) {
  double sum = 0.0;
  for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
    sum += entry->value();
  }
  return sum;
}
