"""Our own ROS packages for pip wheels: where they lie, and the prefix that offers them.

`underlay/src` is a colcon workspace. What is plain Python in it is used from its source folder; what must be
compiled is built at first need. Both are reached through one prefix of links, which is what a learner's
shell, a build and a node see: `write_prefix` makes it, `add_build` puts what was compiled into it.
"""

from course.rosenv.underlay.built import add_build, is_built
from course.rosenv.underlay.prefix import write_prefix
from course.rosenv.underlay.sources import UnderlayPackage, fingerprint, packages_in, source_root

__all__ = [
    "UnderlayPackage",
    "add_build",
    "fingerprint",
    "is_built",
    "packages_in",
    "source_root",
    "write_prefix",
]
