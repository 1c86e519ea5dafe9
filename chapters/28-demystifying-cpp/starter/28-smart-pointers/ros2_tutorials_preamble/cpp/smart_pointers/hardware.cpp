#include "hardware.hpp"

Part* make_part(const std::string& name) {
  Part* part = new Part;
  part->name = name;
  return part;
}

void mount(Part* child, Part* parent) {
  child->parent = parent;
  parent->children.push_back(child);
}

Part* parent_of(Part* part) {
  return part->parent;
}

std::size_t parts_from(Part* part) {
  std::size_t count = 1;
  for (Part* child : part->children) {
    count += parts_from(child);
  }
  return count;
}
