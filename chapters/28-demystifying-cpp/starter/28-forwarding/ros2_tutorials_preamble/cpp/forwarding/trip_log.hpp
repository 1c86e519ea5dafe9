#pragma once

#include <memory>
#include <utility>
#include <vector>

// Creates a new Entry from the arguments, right where it stays.
template <typename Entry, typename... Arguments>
std::shared_ptr<Entry> make(Arguments... arguments) {
  // TODO 1: don't copy the Entry or its arguments.
  Entry entry(arguments...);
  return std::make_shared<Entry>(entry);
}

// Adds an Entry, created from the value, to the end of the vector.
template <typename Entry>
void append(std::vector<Entry>& entries, double value) {
  // TODO 2: create it right in the vector.
  Entry entry(value);
  entries.push_back(entry);
}

// Returns the sum of the values of all entries.
template <typename Entry>
double total(std::vector<Entry> entries) {
  // TODO 3: read the entries without copying them.
  double sum = 0.0;
  for (auto entry : entries) {
    sum += entry.value();
  }
  return sum;
}
