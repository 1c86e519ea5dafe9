from dataclasses import dataclass


@dataclass(frozen=True)
class SampleClass:
    name: str

    def get_name(self) -> str:
        return self.name


sample_function_for_square_of_sum = lambda a, b: (a + b) ** 2  # noqa: E731
