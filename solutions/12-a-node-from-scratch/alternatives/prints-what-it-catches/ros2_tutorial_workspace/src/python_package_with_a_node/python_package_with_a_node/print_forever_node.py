#!/usr/bin/env python3
import rclpy
from rclpy.node import Node


class PrintForeverNode(Node):
    def __init__(self, name: str, period: float) -> None:
        Node.__init__(self, name)
        self._printed = -1
        self._timer = self.create_timer(period, self._on_timer)

    @property
    def printed(self) -> int:
        self._printed += 1
        return self._printed

    def _on_timer(self) -> None:
        log = self.get_logger()
        log.info(f"Printed {self.printed} times.")


def main(args=None) -> None:
    try:
        rclpy.init(args=args)
        node = PrintForeverNode("print_forever", 1 / 2)
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    except Exception as e:
        print(e)


if __name__ == "__main__":
    main()
