#pragma once

#include <map>
#include <memory>
#include <string>

struct Part {
  std::string name;
  std::weak_ptr<Part> above;
  std::map<std::string, std::shared_ptr<Part>> below;
};

using PartPointer = std::shared_ptr<Part>;

inline PartPointer make_part(const char* name) {
  return std::make_shared<Part>(Part{name, {}, {}});
}

inline void mount(PartPointer child, PartPointer parent) {
  child->above = parent;
  parent->below.emplace(child->name, child);
}

inline PartPointer parent_of(PartPointer part) {
  if (auto parent = part->above.lock()) {
    return parent;
  }
  return {};
}

inline int parts_from(const PartPointer& part) {
  int count = 1;
  for (const auto& [name, child] : part->below) {
    count += parts_from(child);
  }
  return count;
}
