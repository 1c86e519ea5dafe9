// Counts what the functions of 28-forwarding create, copy, and move. The argument selects the question.
#include "ask.hpp"
#include "ros2_tutorials_preamble/cpp/forwarding/things.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Count {
  int made = 0;
  int copied = 0;
  int moved = 0;
};

// Counted<0> and Counted<1> have separate counts.
template <int number>
class Counted {
public:
  static inline Count count;

  explicit Counted(double value) : value_(value) { ++count.made; }
  Counted(const Counted& other) : value_(other.value_) { ++count.copied; }
  Counted(Counted&& other) noexcept : value_(std::exchange(other.value_, 0.0)) { ++count.moved; }
  Counted& operator=(const Counted& other) {
    value_ = other.value_;
    ++count.copied;
    return *this;
  }
  Counted& operator=(Counted&& other) noexcept {
    value_ = std::exchange(other.value_, 0.0);
    ++count.moved;
    return *this;
  }
  ~Counted() = default;

  double value() const { return value_; }

private:
  double value_;
};

using Thing = Counted<0>;
using Part = Counted<1>;

// Created from a part: copies a part that the caller keeps, and moves one that nobody needs anymore.
class Whole {
public:
  explicit Whole(const Part& part) : part_(part) {}
  explicit Whole(Part&& part) : part_(std::move(part)) {}
  double value() const { return part_.value(); }

private:
  Part part_;
};

template <typename Type>
std::vector<int> counts() {
  const Count& count = Type::count;
  return {count.made, count.copied, count.moved};
}

void values() {
  ask("made value", [] { return make<Thing>(20.0)->value(); });
  std::vector<Thing> things;
  ask("appended values", [&] {
    append(things, 1.5);
    append(things, -4.0);
    append(things, 8.0);
    std::vector<double> seen;
    for (const Thing& thing : things) {
      seen.push_back(thing.value());
    }
    return seen;
  });
  std::vector<Thing> three;
  for (const double value : {1.5, -4.0, 8.0}) {
    three.emplace_back(value);
  }
  ask("total value", [&] { return total(three); });
}

void made() {
  const auto thing = make<Thing>(20.0);
  ask("make", [] { return counts<Thing>(); });
}

void appended() {
  std::vector<Thing> things;
  things.reserve(3);
  for (const double value : {1.0, 2.0, 3.0}) {
    append(things, value);
  }
  ask("append", [] { return counts<Thing>(); });
}

void totaled() {
  std::vector<Thing> things;
  things.reserve(3);
  for (const double value : {1.0, 2.0, 3.0}) {
    things.emplace_back(value);
  }
  total(things);
  ask("total", [] { return counts<Thing>(); });
}

void forwarded() {
  const Part part(3.0);
  Part ours(5.0);
  make<Whole>(Part(7.0));
  ask("temporary", [] { return counts<Part>(); });
  make<Whole>(part);
  make<Whole>(ours);
  ask("ours", [&] { return ours.value(); });
}

}  // namespace

int main(int, char** arguments) {
  const std::string asked = arguments[1];
  if (asked == "values") {
    values();
  } else if (asked == "make") {
    made();
  } else if (asked == "append") {
    appended();
  } else if (asked == "total") {
    totaled();
  } else {
    forwarded();
  }
  done();
  return 0;
}
