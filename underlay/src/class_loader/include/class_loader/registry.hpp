#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace class_loader::detail
{

/// Classes with the base `BaseT`, of all libraries that are loaded. One for the whole process.
template<typename BaseT>
struct __attribute__((visibility("default"))) Registry
{
  struct Entry
  {
    std::string library;
    std::function<BaseT *()> make;
  };

  std::mutex mutex;
  std::map<std::string, Entry> entries;

  static Registry & get()
  {
    static Registry instance;
    return instance;
  }
};

/// The library whose classes are being registered, by the path that it was asked for. Empty for those that the
/// program is linked with.
__attribute__((visibility("default"))) inline std::string & library_being_loaded()
{
  static thread_local std::string path;
  return path;
}

template<typename DerivedT, typename BaseT>
bool register_class(const std::string & name)
{
  auto & registry = Registry<BaseT>::get();
  const std::lock_guard lock(registry.mutex);
  registry.entries.insert_or_assign(
    name, typename Registry<BaseT>::Entry{
      library_being_loaded(), []() -> BaseT * {return new DerivedT();}});
  return true;
}

}  // namespace class_loader::detail
