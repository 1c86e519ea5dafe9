#pragma once

#include <memory>
#include <numeric>
#include <utility>
#include <vector>

template <typename Entry, typename... Arguments>
auto make(Arguments&&... arguments) -> std::shared_ptr<Entry> {
  return std::shared_ptr<Entry>(new Entry(std::forward<Arguments>(arguments)...));
}

template <typename Entry>
void append(std::vector<Entry>& entries, double value) {
  entries.emplace(entries.end(), value);
}

template <typename Entry>
double total(const std::vector<Entry>& entries) {
  const auto add = [](double sum, const Entry& entry) { return sum + entry.value(); };
  return std::accumulate(entries.begin(), entries.end(), 0.0, add);
}
