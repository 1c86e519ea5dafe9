# The exported target names it.
find_package(Threads REQUIRED)
