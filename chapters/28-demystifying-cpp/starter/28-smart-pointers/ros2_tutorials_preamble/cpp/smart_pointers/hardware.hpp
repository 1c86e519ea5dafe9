#pragma once

#include <cstddef>
#include <string>
#include <vector>

// A part of the rover. It is mounted on its parent, and its children are mounted on it.
struct Part {
  std::string name;
  // TODO 1: decide who owns whom. One of these must be a shared_ptr, and the other a weak_ptr.
  Part* parent = nullptr;
  std::vector<Part*> children;
};

// TODO 2: replace each Part* with a std::shared_ptr<Part>.

// Creates a new part without a parent.
Part* make_part(const std::string& name);

// Mounts the child on the parent.
void mount(Part* child, Part* parent);

// Returns the part that this one is mounted on, or an empty pointer if there is none
// or if it has been deleted.
Part* parent_of(Part* part);

// Counts this part, its children, their children, and so on.
std::size_t parts_from(Part* part);
