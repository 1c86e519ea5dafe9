// Counts what the functions of 28-forwarding create, copy, and move. The argument selects the question.
#include "ask.hpp"
#include "ros2_tutorials_preamble/cpp/forwarding/trip_log.hpp"

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

using Entry = Counted<0>;
using Reading = Counted<1>;

// Created from a reading: copies a reading that the caller keeps, and moves one that nobody needs anymore.
class RangeEntry {
public:
  explicit RangeEntry(const Reading& reading) : reading_(reading) {}
  explicit RangeEntry(Reading&& reading) : reading_(std::move(reading)) {}
  double value() const { return reading_.value(); }

private:
  Reading reading_;
};

template <typename Type>
std::vector<int> counts() {
  const Count& count = Type::count;
  return {count.made, count.copied, count.moved};
}

void values() {
  ask("made value", [] { return make<Entry>(20.0)->value(); });
  std::vector<Entry> entries;
  ask("appended values", [&] {
    append(entries, 1.5);
    append(entries, -4.0);
    append(entries, 8.0);
    std::vector<double> seen;
    for (const Entry& entry : entries) {
      seen.push_back(entry.value());
    }
    return seen;
  });
  std::vector<Entry> three;
  for (const double value : {1.5, -4.0, 8.0}) {
    three.emplace_back(value);
  }
  ask("total value", [&] { return total(three); });
}

void made() {
  const auto entry = make<Entry>(20.0);
  ask("make", [] { return counts<Entry>(); });
}

void appended() {
  std::vector<Entry> entries;
  entries.reserve(3);
  for (const double value : {1.0, 2.0, 3.0}) {
    append(entries, value);
  }
  ask("append", [] { return counts<Entry>(); });
}

void totaled() {
  std::vector<Entry> entries;
  entries.reserve(3);
  for (const double value : {1.0, 2.0, 3.0}) {
    entries.emplace_back(value);
  }
  total(entries);
  ask("total", [] { return counts<Entry>(); });
}

void forwarded() {
  const Reading reading(3.0);
  Reading ours(5.0);
  make<RangeEntry>(Reading(7.0));
  ask("temporary", [] { return counts<Reading>(); });
  make<RangeEntry>(reading);
  make<RangeEntry>(ours);
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
