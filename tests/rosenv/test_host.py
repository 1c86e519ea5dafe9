import sys
from pathlib import Path

from course.rosenv.host import Host


def test_this_machine_is_described() -> None:
    host = Host.here()
    assert host.python == sys.version_info[:2]
    assert host.prefix.samefile(sys.prefix)
    assert Path(__import__("pytest").__file__).is_relative_to(host.site_packages)
    assert host.libc.startswith("glibc ") or host.libc == ""
