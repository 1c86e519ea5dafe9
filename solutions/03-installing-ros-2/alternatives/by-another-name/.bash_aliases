alias say_hello='echo hello'
