#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

// A link of a robot arm. It is mounted on its parent, and its children are mounted on it.
// A link owns its children, but only refers to its parent.
struct Link {
  std::string name;
  std::weak_ptr<Link> parent;
  std::vector<std::shared_ptr<Link>> children;
};

// Creates a new link without a parent.
std::shared_ptr<Link> make_link(const std::string& name);

// Mounts the child on the parent.
void mount(const std::shared_ptr<Link>& child, const std::shared_ptr<Link>& parent);

// Returns the link that this one is mounted on, or an empty pointer if there is none
// or if it has been deleted.
std::shared_ptr<Link> parent_of(const std::shared_ptr<Link>& link);

// Counts this link, its children, their children, and so on.
std::size_t links_from(const std::shared_ptr<Link>& link);
