#pragma once

#include <memory>
#include <utility>
#include <vector>

template <typename Thing, typename... Arguments>
std::shared_ptr<Thing> make(Arguments... arguments) {
  std::allocator<Thing> everyday;
  return std::allocate_shared<Thing>(everyday, std::move(arguments)...);
}

template <typename Thing>
void append(std::vector<Thing>& things, double value) {
  auto& made = things.emplace_back(std::move(value));
  static_cast<void>(made);
}

template <typename Things>
double total(Things&& things) {
  double sum = 0.0;
  for (auto thing = things.begin(); thing != things.end(); ++thing) {
    sum += thing->value();
  }
  return sum;
}
