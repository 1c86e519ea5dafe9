"""Domains for programs: the numbers themselves on a private network, otherwise free ones instead."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from course.errors import MissingHere
from course.isolation import domains as module
from course.isolation.domains import Domains, free_domain

AROUND = 77


@pytest.fixture
def domains(monkeypatch: pytest.MonkeyPatch) -> Iterator[Domains]:
    """On a network that others use. They have the low numbers, which checks take first."""
    monkeypatch.setattr(module, "_DOMAINS", range(101, 50, -1))
    found = Domains(AROUND)
    yield found
    found.close()


@pytest.mark.parametrize("number", [0, 1, 232])
def test_on_a_network_of_its_own_a_number_is_itself(number: int) -> None:
    assert Domains(None).at(number) == number


def test_domain_0_is_the_arenas(domains: Domains) -> None:
    assert domains.at(0) == AROUND


def test_each_other_one_is_a_free_one_and_stays_it(domains: Domains) -> None:
    one, two = domains.at(1), domains.at(2)
    assert len({AROUND, one, two}) == 3
    assert (domains.at(1), domains.at(2)) == (one, two)


def test_nobody_else_gets_it_until_it_is_given_back(
    domains: Domains, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "_DOMAINS", (domains.at(1),))
    with pytest.raises(MissingHere), free_domain():
        pass
    domains.close()
    with free_domain() as again:
        assert again == domains.at(1)
