#pragma once

#include <memory>
#include <utility>
#include <vector>

// Creates a new Thing from the arguments, right where it stays.
template <typename Thing, typename... Arguments>
std::shared_ptr<Thing> make(Arguments&&... arguments) {
  return std::make_shared<Thing>(std::forward<Arguments>(arguments)...);
}

// Adds a Thing, created from the value, to the end of the vector.
template <typename Thing>
void append(std::vector<Thing>& things, double value) {
  things.emplace_back(value);
}

// Returns the sum of the values of all Things.
template <typename Thing>
double total(const std::vector<Thing>& things) {
  double sum = 0.0;
  for (const auto& thing : things) {
    sum += thing.value();
  }
  return sum;
}
