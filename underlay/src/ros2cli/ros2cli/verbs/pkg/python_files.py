"""The files of a new Python package, but for its manifest."""

from __future__ import annotations

from ros2cli.verbs.pkg.plan import VERSION, Plan

TESTS = ("copyright", "flake8", "pep257")

_SETUP = """\
from setuptools import find_packages, setup

package_name = {name!r}

setup(
    name=package_name,
    version={version!r},
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer={maintainer!r},
    maintainer_email={email!r},
    description={description!r},
    license={license!r},
    extras_require={{'test': ['pytest']}},
    entry_points={{
        'console_scripts': [{script}
        ],
    }},
)
"""

_SETUP_CFG = """\
[develop]
script_dir=$base/lib/{name}
[install]
install_scripts=$base/lib/{name}
"""

_NODE = """\
def main():
    print('Hi from {name}.')


if __name__ == '__main__':
    main()
"""

# Without the linter, as on a machine whose ROS 2 comes from pip, the test says so instead of failing.
_TEST_HEAD = """\
import pytest

ament_{linter} = pytest.importorskip('ament_{linter}.main', reason='ament_{linter} is not installed')
"""

_TEST_BODIES = {
    "copyright": """

# Take this mark away once your source files begin with a copyright notice.
@pytest.mark.skip(reason='The files made by ros2 pkg create have no copyright notice.')
@pytest.mark.copyright
@pytest.mark.linter
def test_copyright():
    assert ament_copyright.main(argv=['.', 'test']) == 0, 'Some files have no copyright notice'
""",
    "flake8": """

@pytest.mark.flake8
@pytest.mark.linter
def test_flake8():
    code, errors = ament_flake8.main_with_errors(argv=[])
    assert code == 0, f'{len(errors)} errors or warnings of style:\\n' + '\\n'.join(errors)
""",
    "pep257": """

@pytest.mark.pep257
@pytest.mark.linter
def test_pep257():
    assert ament_pep257.main(argv=['.', 'test']) == 0, 'Some docstrings are missing or malformed'
""",
}


def setup_py(plan: Plan) -> str:
    """Return setup.py, which also tells ROS about the package and its node."""
    script = f"\n            '{plan.node} = {plan.name}.{plan.node}:main'," if plan.node else ""
    return _SETUP.format(
        name=plan.name,
        version=VERSION,
        maintainer=plan.maintainer,
        email=plan.email,
        description=plan.description,
        license=plan.license,
        script=script,
    )


def setup_cfg(plan: Plan) -> str:
    """Return setup.cfg, which puts nodes where `ros2 run` looks for them."""
    return _SETUP_CFG.format(name=plan.name)


def node(plan: Plan) -> str:
    """Return a node's first lines."""
    return _NODE.format(name=plan.name)


def lint_test(linter: str) -> str:
    """Return the test that runs a linter over the package."""
    return _TEST_HEAD.format(linter=linter) + _TEST_BODIES[linter]
