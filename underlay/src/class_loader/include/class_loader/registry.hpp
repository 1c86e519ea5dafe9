#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <typeinfo>

namespace class_loader::detail
{

/// Classes with one base, of all libraries that are loaded.
struct Registry
{
  struct Entry
  {
    std::string library;
    /// Makes an object, and returns it as a pointer to its base.
    std::function<void *()> make;
  };

  std::mutex mutex;
  std::map<std::string, Entry> entries;
};

/// The registry for the base with this name in `typeid`. There is one for the whole process, in this library:
/// a program and the libraries that it loads would each have their own copy of a static variable in a header.
Registry & registry_of(const std::string & base);

template<typename BaseT>
Registry & registry_of()
{
  return registry_of(typeid(BaseT).name());
}

/// The library whose classes are being registered, by the path that it was asked for. Empty for those that the
/// program is linked with.
std::string & library_being_loaded();

template<typename DerivedT, typename BaseT>
bool register_class(const std::string & name)
{
  auto & registry = registry_of<BaseT>();
  const std::lock_guard lock(registry.mutex);
  registry.entries.insert_or_assign(
    name, Registry::Entry{
      library_being_loaded(), []() -> void * {return static_cast<BaseT *>(new DerivedT());}});
  return true;
}

}  // namespace class_loader::detail
