import rclpy
from std_srvs.srv import SetBool


def switch(request, response):
    print("switching")
    response.success = True
    return response


rclpy.init()
node = rclpy.create_node("light")
node.create_service(SetBool, "light", switch)
client = node.create_client(SetBool, "light")
client.wait_for_service()
future = client.call_async(SetBool.Request(data=True))
print(future.done())
rclpy.spin_until_future_complete(node, future)
print(future.done())
rclpy.shutdown()
