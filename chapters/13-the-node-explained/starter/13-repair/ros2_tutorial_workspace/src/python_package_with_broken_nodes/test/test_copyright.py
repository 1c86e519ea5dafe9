import pytest

ament_copyright = pytest.importorskip('ament_copyright.main', reason='ament_copyright is not installed')


# Remove this mark when your source files start with a copyright notice.
@pytest.mark.skip(reason='The files made by ros2 pkg create have no copyright notice.')
@pytest.mark.copyright
@pytest.mark.linter
def test_copyright():
    assert ament_copyright.main(argv=['.', 'test']) == 0, 'Some files have no copyright notice'
