// Builds trees with the functions of 28-smart-pointers. The argument selects the question.
#include "ask.hpp"
#include "ros2_tutorials_preamble/cpp/smart_pointers/link.hpp"

#include <memory>
#include <string>
#include <vector>

namespace {

// The task requires a shared_ptr. A plain pointer does not convert to it.
using Pointer = std::shared_ptr<Link>;

void tree() {
  const Pointer base = make_link("base");
  const Pointer left = make_link("left");
  const Pointer right = make_link("right");
  const Pointer tip = make_link("tip");
  mount(left, base);
  mount(right, base);
  mount(tip, right);
  ask("parents", [&] {
    const Pointer of_left = parent_of(left), of_right = parent_of(right), of_tip = parent_of(tip);
    std::vector<std::string> names;
    for (const Pointer& parent : {of_left, of_right, of_tip}) {
      names.push_back(parent ? parent->name : "nothing");
    }
    return names;
  });
  ask("root", [&] {
    const Pointer parent = parent_of(base);
    return parent ? parent->name : "nothing";
  });
  ask("counts", [&] {
    return std::vector<std::size_t>{links_from(base), links_from(left), links_from(right), links_from(tip)};
  });
}

void kept() {
  const Pointer base = make_link("base");
  mount(make_link("first"), base);
  mount(make_link("second"), base);
  ask("kept", [&] { return links_from(base); });
}

void gone() {
  const Pointer child = make_link("child");
  {
    const Pointer parent = make_link("parent");
    mount(child, parent);
  }
  ask("gone", [&] {
    const Pointer parent = parent_of(child);
    return parent ? parent->name : "nothing";
  });
}

}  // namespace

int main(int, char** arguments) {
  const std::string asked = arguments[1];
  if (asked == "tree") {
    tree();
  } else if (asked == "kept") {
    kept();
  } else {
    gone();
  }
  done();
  return 0;
}
