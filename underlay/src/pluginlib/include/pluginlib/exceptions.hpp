#pragma once

#include <stdexcept>

namespace pluginlib
{

class PluginlibException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A file that describes plugins cannot be read. Class loaders log this, and skip the file.
class InvalidXMLException : public PluginlibException
{
public:
  using PluginlibException::PluginlibException;
};

/// The library of a class is not known, not found, or cannot be loaded.
class LibraryLoadException : public PluginlibException
{
public:
  using PluginlibException::PluginlibException;
};

/// A class loader cannot be made: its package is not known, or a class is described incompletely.
class ClassLoaderException : public PluginlibException
{
public:
  using PluginlibException::PluginlibException;
};

/// A library is to be unloaded that was never loaded.
class LibraryUnloadException : public PluginlibException
{
public:
  using PluginlibException::PluginlibException;
};

/// The library of a class does not register the class.
class CreateClassException : public PluginlibException
{
public:
  using PluginlibException::PluginlibException;
};

}  // namespace pluginlib
