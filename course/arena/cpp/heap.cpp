// Linked with one of the learner's programs: notes everything that `new` allocates, and at the very end
// reports what was never deleted, as the answer to the question "never freed" (see ask.hpp). The leak
// detector of the address sanitizer does the same, but looks into the program from outside, which the
// sandbox forbids.
#include "ask.hpp"

#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>

#include <array>
#include <cstdint>
#include <mutex>
#include <new>

extern "C" void ros2course_watches_the_heap() {}

namespace {

struct Block {
  void* address = nullptr;
  std::size_t size = 0;
};

// The most blocks at once; further ones are not reported. A power of two.
constexpr std::size_t most = 1U << 17U;
constexpr std::size_t most_reported = 20;

std::array<Block, most> blocks;
std::mutex guard;
bool telling = false;

// Not a block's address; marks where one was, so that later ones are still found.
void* const gone = reinterpret_cast<void*>(std::uintptr_t{1});

std::size_t first_place(const void* address) {
  return (reinterpret_cast<std::uintptr_t>(address) >> 4U) * 0x9E3779B97F4A7C15ULL >> 47U;
}

void remember(void* address, std::size_t size) {
  const std::lock_guard<std::mutex> lock(guard);
  if (telling) {
    return;
  }
  for (std::size_t step = 0; step < most; ++step) {
    Block& block = blocks[(first_place(address) + step) % most];
    if (block.address == nullptr || block.address == gone) {
      block = {address, size};
      return;
    }
  }
}

void forget(void* address) {
  const std::lock_guard<std::mutex> lock(guard);
  for (std::size_t step = 0; step < most; ++step) {
    Block& block = blocks[(first_place(address) + step) % most];
    if (block.address == address) {
      block.address = gone;
      return;
    }
    if (block.address == nullptr) {
      return;
    }
  }
}

void* make(std::size_t size, std::size_t alignment = 0) {
  const std::size_t least = size == 0 ? 1 : size;
  void* address =
      alignment == 0 ? std::malloc(least) : std::aligned_alloc(alignment, (least + alignment - 1) / alignment * alignment);
  if (address == nullptr) {
    throw std::bad_alloc();
  }
  remember(address, size);
  return address;
}

void destroy(void* address) {
  if (address != nullptr) {
    forget(address);
    std::free(address);
  }
}

// The place relative to the home, in which the program was compiled; empty for one outside of it.
std::string in_home(std::string place) {
  const char* home = std::getenv("HOME");
  for (const std::string& prefix : {std::string(home == nullptr ? "" : home) + "/", std::string("./")}) {
    if (place.compare(0, prefix.size(), prefix) == 0) {
      place.erase(0, prefix.size());
    }
  }
  // `<null>` stands for code without line information.
  const bool outside = place.empty() || place[0] == '/' || place[0] == '<' || place.compare(0, 3, "../") == 0;
  return outside ? "" : place;
}

// The learner's line that allocated the block, as `file:line`; empty if none did.
std::string made_in(void* address) {
  std::array<void*, 64> trace{};
  int thread = 0;
  const std::size_t depth = __asan_get_alloc_stack(address, trace.data(), trace.size(), &thread);
  for (std::size_t frame = 0; frame < depth; ++frame) {
    char place[1024] = "";
    // We keep the addresses that calls return to; one byte before is inside the call.
    __sanitizer_symbolize_pc(static_cast<char*>(trace[frame]) - 1, "%s:%l", place, sizeof place);
    if (const std::string own = in_home(place); !own.empty()) {
      return own;
    }
  }
  return "";
}

// After the destructors of all objects with static storage.
__attribute__((destructor(101))) void tell() {
  telling = true;
  std::string found = "[";
  std::size_t count = 0;
  for (std::size_t place = 0; place < most; ++place) {
    const Block block = blocks[place];
    if (block.address == nullptr || block.address == gone) {
      continue;
    }
    if (count++ < most_reported) {
      const std::string where = made_in(block.address);
      found += (found.size() > 1 ? ", [" : "[") + std::to_string(block.size) + ", " + ros2course::json(where) + "]";
    }
  }
  ros2course::report("never freed", "value", "[" + std::to_string(count) + ", " + found + "]]", "leaks");
  ros2course::send("\"done\"");
}

}  // namespace

void* operator new(std::size_t size) { return make(size); }
void* operator new[](std::size_t size) { return make(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return make(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return make(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* address) noexcept { destroy(address); }
void operator delete[](void* address) noexcept { destroy(address); }
void operator delete(void* address, std::size_t) noexcept { destroy(address); }
void operator delete[](void* address, std::size_t) noexcept { destroy(address); }
void operator delete(void* address, std::align_val_t) noexcept { destroy(address); }
void operator delete[](void* address, std::align_val_t) noexcept { destroy(address); }
void operator delete(void* address, std::size_t, std::align_val_t) noexcept { destroy(address); }
void operator delete[](void* address, std::size_t, std::align_val_t) noexcept { destroy(address); }
