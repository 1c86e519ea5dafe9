#include "hardware.hpp"

std::shared_ptr<Part> make_part(const std::string& name) {
  auto part = std::make_shared<Part>();
  part->name = name;
  return part;
}

void mount(const std::shared_ptr<Part>& child, const std::shared_ptr<Part>& parent) {
  child->parent = parent;
  parent->children.push_back(child);
}

std::shared_ptr<Part> parent_of(const std::shared_ptr<Part>& part) {
  return part->parent.lock();
}

std::size_t parts_from(const std::shared_ptr<Part>& part) {
  std::size_t count = 1;
  for (const auto& child : part->children) {
    count += parts_from(child);
  }
  return count;
}
