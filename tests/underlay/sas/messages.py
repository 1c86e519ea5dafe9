"""Prints the fields of every message in sas_msgs as JSON, after each went through its type support."""

import json

import sas_msgs.msg
from rclpy.serialization import deserialize_message, serialize_message


def main() -> None:
    kinds = {name: kind for name, kind in vars(sas_msgs.msg).items() if isinstance(kind, type)}
    for kind in kinds.values():
        assert deserialize_message(serialize_message(kind()), kind) == kind()
    print(json.dumps({name: kind.get_fields_and_field_types() for name, kind in kinds.items()}))


if __name__ == "__main__":
    main()
