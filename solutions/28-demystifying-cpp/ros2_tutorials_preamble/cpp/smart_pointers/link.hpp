#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

// A link of a robot arm: it is mounted on its parent, and its children are
// mounted on it. A link owns its children, and only knows its parent.
struct Link {
  std::string name;
  std::weak_ptr<Link> parent;
  std::vector<std::shared_ptr<Link>> children;
};

// A new link, mounted on nothing.
std::shared_ptr<Link> make_link(const std::string& name);

// Mounts the child on the parent.
void mount(const std::shared_ptr<Link>& child, const std::shared_ptr<Link>& parent);

// What the link is mounted on; an empty pointer where there is no such link,
// or where it has been deleted.
std::shared_ptr<Link> parent_of(const std::shared_ptr<Link>& link);

// How many links there are from this one on: itself, its children, theirs ...
std::size_t links_from(const std::shared_ptr<Link>& link);
