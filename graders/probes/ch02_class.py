"""Asks the learner's MinimalistClass, with our numbers. Run by `arena.probe`, which provides `ask`."""

import importlib


def exported():
    return importlib.import_module("minimalist_package").MinimalistClass


def hidden():
    return importlib.import_module("minimalist_package._minimalist_class").MinimalistClass


cls = ask("export", exported) or ask("class", hidden)
ask("made", cls)
ask("reference", lambda: cls.attribute_reference)
ask("default attribute", lambda: cls().attribute)
ask("default private", lambda: cls()._private_attribute)
ask("by name", lambda: cls(private_attribute_arg=2.5, attribute_arg=1.5).attribute)
ask("private by name", lambda: cls(private_attribute_arg=2.5, attribute_arg=1.5)._private_attribute)
ask("default sum", lambda: cls().method())
ask("sum", lambda: cls(1.5, -4.0).method())


def after(change, question):
    one = cls(1.5, 2.5)
    change(one)
    return question(one)


ask("sum later", lambda: after(lambda one: setattr(one, "attribute", 7.0), lambda one: one.method()))
ask("get", lambda: cls(1.5, 2.5).get_private_attribute())
ask(
    "set and get",
    lambda: after(lambda one: one.set_private_attribute(8.0), lambda one: one.get_private_attribute()),
)
ask("static", lambda: cls.static_method())
ask("static of an object", lambda: cls().static_method())


def two(change):
    first, second = cls(1.5, 2.5), cls(3.5, 4.5)
    change(first)
    return [first.attribute, first.get_private_attribute(), second.attribute, second.get_private_attribute()]


ask("apart", lambda: two(lambda first: None))
ask("still apart", lambda: two(lambda first: first.set_private_attribute(8.0)))
