// Builds trees with the functions of 28-smart-pointers. The argument selects the question.
#include "ask.hpp"
#include "ros2_tutorials_preamble/cpp/smart_pointers/hardware.hpp"

#include <memory>
#include <string>
#include <vector>

namespace {

// The task requires a shared_ptr. A plain pointer does not convert to it.
using Pointer = std::shared_ptr<Part>;

void tree() {
  const Pointer body = make_part("body");
  const Pointer mast = make_part("mast");
  const Pointer axle = make_part("axle");
  const Pointer wheel = make_part("wheel");
  mount(mast, body);
  mount(axle, body);
  mount(wheel, axle);
  ask("parents", [&] {
    const Pointer of_mast = parent_of(mast), of_axle = parent_of(axle), of_wheel = parent_of(wheel);
    std::vector<std::string> names;
    for (const Pointer& parent : {of_mast, of_axle, of_wheel}) {
      names.push_back(parent ? parent->name : "nothing");
    }
    return names;
  });
  ask("root", [&] {
    const Pointer parent = parent_of(body);
    return parent ? parent->name : "nothing";
  });
  ask("counts", [&] {
    return std::vector<std::size_t>{parts_from(body), parts_from(mast), parts_from(axle), parts_from(wheel)};
  });
}

void kept() {
  const Pointer body = make_part("body");
  mount(make_part("left wheel"), body);
  mount(make_part("right wheel"), body);
  ask("kept", [&] { return parts_from(body); });
}

void gone() {
  const Pointer child = make_part("child");
  {
    const Pointer parent = make_part("parent");
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
