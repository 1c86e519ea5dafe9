"""Every capture of a command among nodes, case by case; and that no capture is left out anywhere."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.underlay.cli.captured import CAPTURES, case
from tests.underlay.cli.normal import expected, normal
from tests.underlay.cli.place import among

# The nodes that are there, and what is typed one after the other.
SITUATIONS: dict[str, tuple[str, str]] = {
    "nothing": (
        "",
        "node_list_empty_nodaemon daemon_start daemon_start_again daemon_status_running daemon_stop "
        "daemon_stop_stopped doctor doctor_noverb wtf",
    ),
    "publisher": (
        "publisher",
        "daemon_start node_list node_list_a node_list_c node_info node_info_unknown topic_list topic_list_c "
        "topic_list_hidden topic_list_t topic_list_v topic_info topic_info_noslash topic_info_v topic_type "
        "topic_type_noslash topic_type_unknown topic_find topic_find_none topic_find_badtype service_list "
        "doctor_pub_without_sub",
    ),
    "publisher, no daemon": (
        "publisher",
        "node_list_nodaemon node_list_a_nodaemon node_list_c_nodaemon node_info_nodaemon "
        "node_info_unknown_nodaemon topic_list_nodaemon topic_list_c_nodaemon topic_list_hidden_nodaemon "
        "topic_list_t_nodaemon topic_list_v_nodaemon topic_info_nodaemon topic_info_noslash_nodaemon "
        "topic_info_v_nodaemon topic_type_nodaemon topic_type_noslash_nodaemon topic_type_unknown_nodaemon "
        "topic_find_nodaemon topic_find_badtype_nodaemon topic_find_none_nodaemon service_list_nodaemon "
        "topic_echo_nodaemon topic_echo_noslash_nodaemon topic_echo_once_nodaemon "
        "topic_echo_unknown_nodaemon",
    ),
    "listening": (
        "publisher",
        "topic_echo topic_echo_csv topic_echo_field_bad topic_echo_filter topic_echo_flow_style "
        "topic_echo_grep topic_echo_head topic_echo_noslash topic_echo_once topic_echo_raw "
        "topic_echo_sigint_pid_only topic_echo_sigterm topic_echo_tty topic_echo_unknown "
        "topic_echo_unpublished_typed",
    ),
    "measuring": ("publisher", "topic_hz topic_hz_unknown topic_bw topic_bw_unknown"),
    "both": (
        "publisher subscriber",
        "daemon_start topic_list_v_pub_and_sub topic_info_v_pub_and_sub doctor_with_nodes",
    ),
    "subscriber": (
        "subscriber",
        "topic_pub_once topic_pub_once_empty topic_pub_once_yaml_plain topic_pub_2part_type topic_pub_times3 "
        "topic_pub_rate topic_pub_bad_field topic_pub_bad_value topic_pub_not_dict topic_pub_bad_pkg "
        "topic_pub_bad_type topic_pub_wrong_type_topic",
    ),
    "nobody listens": ("", "topic_pub_rate_no_subscriber"),
    "server": (
        "server",
        "service_list_srv service_list_srv_nodaemon service_list_hidden service_list_t "
        "service_list_t_nodaemon service_list_c service_type service_type_noslash service_type_unknown "
        "service_find service_find_badtype service_info service_info_nodaemon service_info_unknown "
        "node_info_service_server",
    ),
    "calling": (
        "server",
        "service_call service_call_2part_type service_call_empty service_call_rate service_call_bad_field "
        "service_call_bad_pkg service_call_bad_type service_call_bad_value service_call_bad_yaml "
        "service_call_malformed_type service_call_not_dict service_call_no_server "
        "service_call_wrong_type_server",
    ),
    "parameters": (
        "parameters",
        "param_list param_list_nodaemon param_list_node param_list_node_nodaemon param_list_type "
        "param_list_unknown param_get param_get_nodaemon param_get_noslash param_get_bool param_get_double "
        "param_get_double_nodaemon param_get_unknown_node param_describe param_describe_nodaemon "
        "param_describe_two param_describe_unknown_node param_describe_use_sim_time param_dump "
        "param_dump_nodaemon param_dump_unknown_node",
    ),
    "setting": (
        "parameters",
        "param_set param_set_nodaemon param_set_int_for_double param_set_int_for_string "
        "param_set_quoted_yaml param_set_readonly_like param_set_undeclared param_set_unknown_node "
        "param_set_wrong_type param_delete_static param_load_broken_yaml param_load_other_node "
        "param_get_after param_load_wildcard",
    ),
    "running": (
        "",
        "run_bad_ros_args run_params_cli run_ok_spins run_ok_spins_sigterm run_ok_spins_sigkill "
        "run_ok_spins_sigint_ros2_only run_ok_spins_tty",
    ),
    "running among others": ("publisher", "run_subscriber"),
}
# Compared in part, or not at all.
EXCEPTIONS = {
    "topic_hz_noslash": "a name without a slash is found here: test_talking",
    "doctor_report": "addresses, versions and names of the machine: test_doctor",
}
_OTHER_FOLDERS = {"launch_": "tests/underlay/launch"}


@pytest.mark.slow
@pytest.mark.parametrize("situation", SITUATIONS)
def test_as_the_real_one(situation: str, workspace: Path) -> None:
    nodes, names = (text.split() for text in SITUATIONS[situation])
    cases = [case(name) for name in names]
    outcomes = among(nodes, [case.job() for case in cases], workspace)
    ours = {c.name: normal(outcome, c) for c, outcome in zip(cases, outcomes, strict=True)}
    assert ours == {c.name: expected(c) for c in cases}


def test_no_capture_is_left_out() -> None:
    named = {word for text in _texts_of_tests() for word in text.split()}
    captures = {file.stem for file in CAPTURES.glob("*.txt")}
    ours = {name for name in captures if not name.startswith(tuple(_OTHER_FOLDERS))}
    assert ours - named == set()
    assert set(EXCEPTIONS) <= captures


def _texts_of_tests() -> Iterator[str]:
    """What the tests have in quotes, without docstrings."""
    folder = Path(__file__).parents[1]
    for file in (*folder.glob("cli/test_*.py"), *folder.glob("runtime/test_*.py")):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        spoken = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
        for node in ast.walk(tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in spoken:
                yield node.value
