"""Check that docstrings follow PEP 257."""

import pytest

pep257_check = pytest.importorskip('ament_pep257.main')


@pytest.mark.linter
@pytest.mark.pep257
def test_pep257():
    assert pep257_check.main(argv=['.', 'test']) == 0
