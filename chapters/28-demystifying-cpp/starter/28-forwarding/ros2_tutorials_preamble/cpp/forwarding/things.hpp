#pragma once

#include <memory>
#include <utility>
#include <vector>

// Creates a new Thing from the arguments, right where it stays.
template <typename Thing, typename... Arguments>
std::shared_ptr<Thing> make(Arguments... arguments) {
  // TODO 1: don't copy the Thing or its arguments.
  Thing thing(arguments...);
  return std::make_shared<Thing>(thing);
}

// Adds a Thing, created from the value, to the end of the vector.
template <typename Thing>
void append(std::vector<Thing>& things, double value) {
  // TODO 2: create it right in the vector.
  Thing thing(value);
  things.push_back(thing);
}

// Returns the sum of the values of all Things.
template <typename Thing>
double total(std::vector<Thing> things) {
  // TODO 3: read the things without copying them.
  double sum = 0.0;
  for (auto thing : things) {
    sum += thing.value();
  }
  return sum;
}
