from std_msgs.msg import Float64

message = Float64()
print(message.data)
message.data = 20
print(message.data)
