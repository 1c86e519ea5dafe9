"""Listings among running nodes, compared with the captures; once with the daemon, once without."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from tests.underlay.cli.place import Outcome, captured, normal, ros2_among

pytestmark = pytest.mark.slow

_PUBLISHER = (
    "node_list node_list_a node_list_c node_info node_info_unknown topic_list topic_list_c "
    "topic_list_hidden topic_list_t topic_list_v topic_info topic_info_noslash topic_info_v "
    "topic_type topic_type_noslash topic_type_unknown topic_find topic_find_none "
    "topic_find_badtype service_list topic_echo_unknown"
).split()
_WITHOUT_DAEMON = (
    "node_list_nodaemon node_list_a_nodaemon node_info_nodaemon node_info_unknown_nodaemon "
    "topic_list_nodaemon topic_list_t_nodaemon topic_list_v_nodaemon topic_info_nodaemon "
    "topic_info_v_nodaemon topic_type_nodaemon topic_find_nodaemon topic_echo_unknown_nodaemon "
    "service_list_nodaemon"
).split()
_SERVER = (
    "service_list_srv service_list_hidden service_list_t service_list_c service_type "
    "service_type_noslash service_type_unknown service_find service_find_badtype service_info "
    "service_info_unknown node_info_service_server"
).split()
_DAEMON = "daemon_stop daemon_stop_stopped daemon_start daemon_start_again daemon_status_running".split()


def _compare(nodes: Sequence[str], names: Sequence[str]) -> None:
    cases = [captured(name) for name in names]
    outcomes = ros2_among(nodes, [(_typed(arguments), None) for arguments, _ in cases])
    expected = {name: outcome for name, (_, outcome) in zip(names, cases, strict=True)}
    assert dict(zip(names, outcomes, strict=True)) == expected


def _typed(arguments: Sequence[str]) -> list[str]:
    """With the types that the nodes of these tests have."""
    return [normal(argument) for argument in arguments]


def test_publisher() -> None:
    _compare(["publisher"], ["daemon_start", *_PUBLISHER])


def test_publisher_without_daemon() -> None:
    _compare(["publisher"], _WITHOUT_DAEMON)


def test_publisher_and_subscriber() -> None:
    _compare(
        ["publisher", "subscriber"], ["daemon_start", "topic_list_v_pub_and_sub", "topic_info_v_pub_and_sub"]
    )


def test_server() -> None:
    _compare(["server"], _SERVER)


def test_daemon() -> None:
    _compare([], ["daemon_start", *_DAEMON])


def test_listings_without_daemon_are_complete_every_time() -> None:
    cases: list[tuple[list[str], float | None]] = [(["node", "list", "--no-daemon"], None)] * 8
    seen = {outcome.stdout for outcome in ros2_among(["publisher", "server", "parameters"], cases)}
    nodes = ("configurable_publisher_node", "publisher_node")
    lines = [*(f"/amazing_quote_{name}" for name in nodes), "/what_is_the_point_service_server"]
    assert seen == {"\n".join(lines) + "\n"}


def test_a_first_listing_starts_the_daemon() -> None:
    cases: list[tuple[list[str], float | None]] = [(["topic", "list"], None), (["daemon", "start"], None)]
    outcome = ros2_among(["publisher"], cases)[0]
    assert outcome == Outcome(0, "/amazing_quote\n/parameter_events\n/rosout\n", "")
