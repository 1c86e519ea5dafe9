class Rover:
    stops = []

    def visit(self, place):
        self.stops.append(place)


first = Rover()
second = Rover()
first.visit("dock")
print(first.stops)
print(second.stops)
