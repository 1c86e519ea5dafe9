#pragma once

#include <memory>
#include <utility>
#include <vector>

// Creates a new Entry from the arguments, right where it stays.
template <typename Entry, typename... Arguments>
std::shared_ptr<Entry> make(Arguments&&... arguments) {
  return std::make_shared<Entry>(std::forward<Arguments>(arguments)...);
}

// Adds an Entry, created from the value, to the end of the vector.
template <typename Entry>
void append(std::vector<Entry>& entries, double value) {
  entries.emplace_back(value);
}

// Returns the sum of the values of all entries.
template <typename Entry>
double total(const std::vector<Entry>& entries) {
  double sum = 0.0;
  for (const auto& entry : entries) {
    sum += entry.value();
  }
  return sum;
}
