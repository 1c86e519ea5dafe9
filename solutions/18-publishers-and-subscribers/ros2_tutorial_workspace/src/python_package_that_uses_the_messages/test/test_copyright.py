"""Check that every source file has a copyright notice."""

import pytest

copyright_check = pytest.importorskip('ament_copyright.main')


@pytest.mark.skip(reason='remove this line when your files have a notice')
@pytest.mark.copyright
@pytest.mark.linter
def test_copyright():
    assert copyright_check.main(argv=['.', 'test']) == 0
