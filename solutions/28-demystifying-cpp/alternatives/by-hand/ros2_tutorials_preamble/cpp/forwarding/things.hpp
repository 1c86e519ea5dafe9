#pragma once

#include <memory>
#include <numeric>
#include <utility>
#include <vector>

template <typename Thing, typename... Arguments>
auto make(Arguments&&... arguments) -> std::shared_ptr<Thing> {
  return std::shared_ptr<Thing>(new Thing(std::forward<Arguments>(arguments)...));
}

template <typename Thing>
void append(std::vector<Thing>& things, double value) {
  things.emplace(things.end(), value);
}

template <typename Thing>
double total(const std::vector<Thing>& things) {
  const auto add = [](double sum, const Thing& thing) { return sum + thing.value(); };
  return std::accumulate(things.begin(), things.end(), 0.0, add);
}
