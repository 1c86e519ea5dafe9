"""What is to be said of each faulty program: the first place to look at, and words of the advice."""

from __future__ import annotations

_SUPER = "Call `super().__init__('name_of_the_node')` first"
_NO_NODE = "must derive from Node"

EXPECTED = {
    # rclpy
    "no_init": ("faulty/no_init.py:7", "Call `rclpy.init()` at the beginning"),
    "init_twice": ("faulty/init_twice.py:12", "Call `rclpy.init()` once only"),
    "message_class": ("faulty/message_class.py:8", "without quotes"),
    "qos_missing": ("faulty/qos_missing.py:9", ", 10)"),
    "bad_topic": ("faulty/bad_topic.py:9", "A topic's name may hold"),
    # services and parameters
    "no_response": ("faulty/no_response.py:14", "The response is not returned: `switch` must end with"),
    "request_field": ("faulty/request_field.py:15", "belong to the response: `response.success`"),
    "undeclared": ("faulty/undeclared.py:9", "`self.declare_parameter('author', ...)`"),
    "undeclared_slip": ("faulty/undeclared_slip.py:9", "declares `quote`, and asks for `qoute`"),
    # the node's class
    "bad_name": ("faulty/bad_name.py:7", "A node's name may hold"),
    "name_digit": ("faulty/name_digit.py:7", "does not begin with a digit"),
    "no_name": ("faulty/no_name.py:7", "A node needs a name"),
    "not_a_node": ("faulty/not_a_node.py:7", _NO_NODE),
    "not_a_node_no_super": ("faulty/not_a_node_no_super.py:7", _NO_NODE),
    "no_super_logger": ("faulty/no_super_logger.py:7", _SUPER),
    "no_super_parameter": ("faulty/no_super_parameter.py:7", _SUPER),
    "no_super_publisher": ("faulty/no_super_publisher.py:8", _SUPER),
    "no_super_spin": ("faulty/no_super_spin.py:12", _SUPER),
    "no_super_timer": ("faulty/no_super_timer.py:7", _SUPER),
    # brackets
    "logger_not_called": ("faulty/logger_not_called.py:8", "`get_logger()` needs its brackets"),
    "callback_called": ("faulty/callback_called.py:8", "`self.tick`, without brackets"),
    "subscription_called": ("faulty/subscription_called.py:9", "`self.hear`, without brackets"),
    # what Python cannot read
    "syntax": ("faulty/syntax.py:10", "Python cannot read the file"),
    "bracket": ("faulty/bracket.py:11", "Python cannot read the file"),
    "indent": ("faulty/indent.py:12", "spaces at the beginning"),
    "tabs": ("faulty/tabs.py:12", "begins with a tab"),
    # imports
    "no_message": ("faulty/no_message.py:3", "`std_msgs.msg` has nothing called `Strin`"),
    "no_message_module": ("faulty/no_message_module.py:3", "is `std_msgs.mgs` spelt right"),
    "no_message_package": ("faulty/no_message_package.py:3", "is `std_msg` spelt right"),
    "plain_import": ("faulty/plain_import.py:3", "`faulty.helper` in place of `helper`"),
    "circular": ("faulty/circular.py:1", "import each other"),
    # entry points
    "module_only": ("setup.py:12", "`module_only = faulty.helper:main`"),
    "wrong_function": ("setup.py:12", "names the function `mian`; `faulty.ended` has `main`"),
    "wrong_module": ("setup.py:12", "The package has `ended` and `helper`"),
    "lost_module": ("lost.py", "Move it to `ros2_tutorial_workspace/src/faulty/faulty/lost.py`"),
    "no_main": ("setup.py:12", "names the function `main`; `faulty.no_main` has none"),
    "helper": ("setup.py:12", "names the function `main`; `faulty.helper` has `help_out`"),
    # no rule knows more than the traceback
    "chained": ("faulty/chained.py:11", "the line named here"),
    "during": ("faulty/during.py:11", "the line named here"),
    "wrong_field": ("faulty/wrong_field.py:10", "the line named here"),
    "callback_arguments": ("faulty/callback_arguments.py:16", "the line named here"),
    "notes": ("faulty/notes.py:8", "the line named here"),
}
