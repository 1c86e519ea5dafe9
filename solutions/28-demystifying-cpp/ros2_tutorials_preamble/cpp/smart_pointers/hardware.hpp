#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

// A part of the rover. It is mounted on its parent, and its children are mounted on it.
// A part owns its children, but only refers to its parent.
struct Part {
  std::string name;
  std::weak_ptr<Part> parent;
  std::vector<std::shared_ptr<Part>> children;
};

// Creates a new part without a parent.
std::shared_ptr<Part> make_part(const std::string& name);

// Mounts the child on the parent.
void mount(const std::shared_ptr<Part>& child, const std::shared_ptr<Part>& parent);

// Returns the part that this one is mounted on, or an empty pointer if there is none
// or if it has been deleted.
std::shared_ptr<Part> parent_of(const std::shared_ptr<Part>& part);

// Counts this part, its children, their children, and so on.
std::size_t parts_from(const std::shared_ptr<Part>& part);
