"""Asks without waiting for answers. SIZE: letters of each question."""


def flood(node):
    from package_with_interfaces.srv import WhatIsThePoint

    request = WhatIsThePoint.Request()
    request.quote.quote = "life " * SIZE
    asking = node.create_client(WhatIsThePoint, "/what_is_the_point")
    while True:
        if asking.service_is_ready():
            asking.call_async(request)


beside(flood)
