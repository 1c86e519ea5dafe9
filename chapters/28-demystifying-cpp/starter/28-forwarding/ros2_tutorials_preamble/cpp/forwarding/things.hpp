#pragma once

#include <memory>
#include <utility>
#include <vector>

// Makes a new Thing from these arguments, where it stays.
template <typename Thing, typename... Arguments>
std::shared_ptr<Thing> make(Arguments... arguments) {
  // TODO 1: copy neither the Thing nor its arguments.
  Thing thing(arguments...);
  return std::make_shared<Thing>(thing);
}

// Adds a Thing made from the value to the end of the vector.
template <typename Thing>
void append(std::vector<Thing>& things, double value) {
  // TODO 2: make it directly in the vector.
  Thing thing(value);
  things.push_back(thing);
}

// Returns the sum of the values of all Things.
template <typename Thing>
double total(std::vector<Thing> things) {
  // TODO 3: look at the things without copying them.
  double sum = 0.0;
  for (auto thing : things) {
    sum += thing.value();
  }
  return sum;
}
