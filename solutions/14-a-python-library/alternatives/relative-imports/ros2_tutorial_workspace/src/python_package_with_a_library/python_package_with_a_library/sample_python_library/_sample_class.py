class SampleClass:
    def __init__(self, name='nobody'):
        self.__name = name

    @property
    def name(self):
        return self.__name

    def get_name(self):
        return self.name
