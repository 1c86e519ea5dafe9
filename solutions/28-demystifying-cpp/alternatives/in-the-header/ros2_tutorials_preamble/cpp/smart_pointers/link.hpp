#pragma once

#include <map>
#include <memory>
#include <string>

struct Link {
  std::string name;
  std::weak_ptr<Link> above;
  std::map<std::string, std::shared_ptr<Link>> below;
};

using LinkPointer = std::shared_ptr<Link>;

inline LinkPointer make_link(const char* name) {
  return std::make_shared<Link>(Link{name, {}, {}});
}

inline void mount(LinkPointer child, LinkPointer parent) {
  child->above = parent;
  parent->below.emplace(child->name, child);
}

inline LinkPointer parent_of(LinkPointer link) {
  if (auto parent = link->above.lock()) {
    return parent;
  }
  return {};
}

inline int links_from(const LinkPointer& link) {
  int count = 1;
  for (const auto& [name, child] : link->below) {
    count += links_from(child);
  }
  return count;
}
