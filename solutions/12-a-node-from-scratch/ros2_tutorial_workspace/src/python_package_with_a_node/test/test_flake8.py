"""Check the code against the style rules of flake8."""

import pytest

flake8_check = pytest.importorskip('ament_flake8.main')


@pytest.mark.flake8
@pytest.mark.linter
def test_flake8():
    code, findings = flake8_check.main_with_errors(argv=[])
    assert code == 0, '\n'.join(findings)
