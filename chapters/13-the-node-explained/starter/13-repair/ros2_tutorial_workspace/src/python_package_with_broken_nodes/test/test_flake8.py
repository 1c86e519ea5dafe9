import pytest

ament_flake8 = pytest.importorskip('ament_flake8.main', reason='ament_flake8 is not installed')


@pytest.mark.flake8
@pytest.mark.linter
def test_flake8():
    code, errors = ament_flake8.main_with_errors(argv=[])
    assert code == 0, f'{len(errors)} errors or warnings of style:\n' + '\n'.join(errors)
