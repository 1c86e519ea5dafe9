#include "link.hpp"

std::shared_ptr<Link> make_link(const std::string& name) {
  auto link = std::make_shared<Link>();
  link->name = name;
  return link;
}

void mount(const std::shared_ptr<Link>& child, const std::shared_ptr<Link>& parent) {
  child->parent = parent;
  parent->children.push_back(child);
}

std::shared_ptr<Link> parent_of(const std::shared_ptr<Link>& link) {
  return link->parent.lock();
}

std::size_t links_from(const std::shared_ptr<Link>& link) {
  std::size_t count = 1;
  for (const auto& child : link->children) {
    count += links_from(child);
  }
  return count;
}
