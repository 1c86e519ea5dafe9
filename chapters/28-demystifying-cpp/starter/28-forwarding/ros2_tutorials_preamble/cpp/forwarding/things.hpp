#pragma once

#include <memory>
#include <utility>
#include <vector>

// A new Thing, made of these arguments where it stays.
template <typename Thing, typename... Arguments>
std::shared_ptr<Thing> make(Arguments... arguments) {
  // TODO 1: no copy, neither of the Thing nor of what it is made of.
  Thing thing(arguments...);
  return std::make_shared<Thing>(thing);
}

// Adds a Thing that is made of the value to the end of the vector.
template <typename Thing>
void append(std::vector<Thing>& things, double value) {
  // TODO 2: make it in the vector itself.
  Thing thing(value);
  things.push_back(thing);
}

// The sum of the values of all Things.
template <typename Thing>
double total(std::vector<Thing> things) {
  // TODO 3: looking at things needs no copies of them.
  double sum = 0.0;
  for (auto thing : things) {
    sum += thing.value();
  }
  return sum;
}
