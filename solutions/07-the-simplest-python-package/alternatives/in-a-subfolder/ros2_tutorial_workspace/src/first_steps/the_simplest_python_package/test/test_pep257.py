import pytest

ament_pep257 = pytest.importorskip('ament_pep257.main', reason='ament_pep257 is not installed')


@pytest.mark.pep257
@pytest.mark.linter
def test_pep257():
    assert ament_pep257.main(argv=['.', 'test']) == 0, 'Some docstrings are missing or malformed'
