"""Calls of a node's parameter services, as a recording contains them."""

from __future__ import annotations

from struct import pack

from course.evidence.parameter_view import ParameterData
from course.model.events import Event, ServiceAnswered, ServiceCalled

NODE = "/talker"
VALUE = "uint8 type\nbool bool_value\nint64 integer_value\nfloat64 double_value\nstring string_value\n"
KINDS = "rcl_interfaces/srv/"
SEPARATOR = "=" * 80
INNER = f"{SEPARATOR}\nMSG: rcl_interfaces/ParameterValue\n{VALUE}"
DEFINITIONS = {
    f"{KINDS}GetParameters_Request": "string[] names\n",
    f"{KINDS}GetParameters_Response": f"rcl_interfaces/ParameterValue[] values\n{INNER}",
    f"{KINDS}ListParameters_Request": "",
    f"{KINDS}ListParameters_Response": "rcl_interfaces/Result result\n"
    f"{SEPARATOR}\nMSG: rcl_interfaces/Result\nstring[] names\n",
    f"{KINDS}SetParameters_Request": "rcl_interfaces/Parameter[] parameters\n"
    f"{SEPARATOR}\nMSG: rcl_interfaces/Parameter\nstring name\nrcl_interfaces/ParameterValue value\n{INNER}",
    f"{KINDS}SetParameters_Response": "rcl_interfaces/Result[] results\n"
    f"{SEPARATOR}\nMSG: rcl_interfaces/Result\nbool successful\nstring reason\n",
}


class Cdr:
    """Just enough of CDR for these tests."""

    def __init__(self) -> None:
        self.body = b""

    def number(self, form: str, value: float, size: int) -> Cdr:
        self.body += bytes(-len(self.body) % size) + pack(f"<{form}", value)
        return self

    def string(self, text: str) -> Cdr:
        data = text.encode() + b"\0"
        self.number("I", len(data), 4)
        self.body += data
        return self

    def value(self, value: ParameterData) -> Cdr:
        kinds = {bool: 1, int: 2, float: 3, str: 4}
        self.number("B", kinds[type(value)], 1).number("B", int(value is True), 1)
        self.number("q", value if type(value) is int else 0, 8)
        self.number("d", value if isinstance(value, float) else 0.0, 8)
        return self.string(value if isinstance(value, str) else "")

    @property
    def data(self) -> bytes:
        return b"\0\1\0\0" + self.body


def call(t: float, service: str, kind: str, request: Cdr, response: Cdr | None) -> tuple[Event, ...]:
    name, type_name, id = f"{NODE}/{service}", f"{KINDS}{kind}", f"{service} {t}"
    asked = ServiceCalled(t, name, type_name, "client", id, "client 1", request.data)
    if response is None:
        return (asked,)
    return asked, ServiceAnswered(t + 0.1, name, type_name, "client", id, response.data)


def got(t: float, name: str, value: ParameterData | None) -> tuple[Event, ...]:
    """value: None if the parameter is not declared."""
    response = Cdr().number("I", 0, 4) if value is None else Cdr().number("I", 1, 4).value(value)
    return call(t, "get_parameters", "GetParameters", Cdr().number("I", 1, 4).string(name), response)


def listed(t: float, *names: str) -> tuple[Event, ...]:
    response = Cdr().number("I", len(names), 4)
    for name in names:
        response.string(name)
    return call(t, "list_parameters", "ListParameters", Cdr(), response)


def set_to(t: float, name: str, value: ParameterData, answer: str | None) -> tuple[Event, ...]:
    """answer: the reason for a refusal, "" if it is accepted, None if none comes."""
    request = Cdr().number("I", 1, 4).string(name).value(value)
    response = (
        None if answer is None else Cdr().number("I", 1, 4).number("B", int(not answer), 1).string(answer)
    )
    return call(t, "set_parameters", "SetParameters", request, response)
