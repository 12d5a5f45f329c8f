"""Rules without one of their conditions: some attack has to succeed then, or it was never made.

A plugin of pytest's, for `make ci`, with ``-s``: each ``if ...: raise`` of the modules of rules
is left out in a process of its own, in which one of the tests that were collected has to fail.
Those that name the rule come first.
"""

from __future__ import annotations
import __future__

import ast
import importlib
import inspect
import os
import re
import signal
from collections.abc import Callable, Iterator
from functools import cache
from types import ModuleType

import pytest

from symhaptic.proof.theorems import kernel

LONG = 300
"""Seconds in which an attack has to succeed."""

Condition = tuple[ModuleType, ast.FunctionDef, ast.If]


def conditions() -> Iterator[Condition]:
    """Each condition of a rule, or of what rules call, with the function in which it stands."""
    for name in kernel.MODULES:
        module = importlib.import_module(f"{kernel.__package__}.{name}")
        assert module.__file__ is not None
        with open(module.__file__, encoding="utf-8") as file:
            tree = ast.parse(file.read())
        for function in tree.body:
            if isinstance(function, ast.FunctionDef):
                for node in ast.walk(function):
                    if isinstance(node, ast.If) and isinstance(node.body[0], ast.Raise):
                        yield module, function, node


def leave_out(module: ModuleType, function: ast.FunctionDef, condition: ast.If) -> None:
    """From here on the function does not ask for the condition, whoever has imported it."""
    condition.body = [ast.copy_location(ast.Pass(), condition)]
    rules = [d for d in function.decorator_list if isinstance(d, ast.Name) and d.id == "rule"]
    function.decorator_list = [d for d in function.decorator_list if d not in rules]
    flags = __future__.annotations.compiler_flag
    code = compile(ast.Module([function], []), str(module.__file__), "exec", flags=flags)
    made: dict[str, object] = {}
    exec(code, vars(module), made)
    if rules:
        kernel._RULES[function.name] = made[function.name]  # type: ignore[assignment]
        return
    old = getattr(module, function.name)
    for name in kernel.MODULES:
        other = importlib.import_module(f"{kernel.__package__}.{name}")
        if vars(other).get(function.name) is old:
            setattr(other, function.name, made[function.name])


def naming(condition: Condition) -> set[str]:
    """The function of a condition, and those of its module that call it."""
    module, function, _ = condition
    found = {function.name}
    for name, other in vars(module).items():
        if inspect.isfunction(other) and function.name in inspect.unwrap(other).__code__.co_names:
            found.add(name)
    return found


@cache
def words(test: Callable[..., object]) -> frozenset[str]:
    """The words in the source of a test, which many of its cases share."""
    return frozenset(re.findall(r"\w+", inspect.getsource(test)))


def order(items: list[pytest.Item], condition: Condition | None) -> list[pytest.Item]:
    """The tests, those first that name the function of the condition or what calls it."""
    names = set() if condition is None else naming(condition)

    def far(item: pytest.Item) -> tuple[bool, bool]:
        near = not names.isdisjoint(words(getattr(item, "function", far)))
        return not near, not any(name.strip("_") in item.nodeid for name in names)

    return sorted(items, key=far)


def attacked(session: pytest.Session, condition: Condition | None) -> int:
    """In a process of its own: the exit status says whether an attack succeeds."""
    items = order(session.items, condition)  # here, where the words of each test are kept
    if child := os.fork():
        return child
    signal.alarm(LONG)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    os.dup2(nowhere, 2)
    if condition is not None:
        leave_out(*condition)
    for item in items:
        item.config.hook.pytest_runtest_protocol(item=item, nextitem=None)
        if session.testsfailed:
            os._exit(0)
    os._exit(1)


def pytest_runtestloop(session: pytest.Session) -> bool:
    """Leave out one condition after the other, as many at once as there are processors.

    With all of them no attack succeeds, or a test that fails by itself would pass for one.
    """
    waiting: list[Condition | None] = [None, *conditions()]
    under_way, missed, count = dict[int, Condition | None](), list[str](), len(waiting) - 1
    while waiting or under_way:
        while waiting and len(under_way) < (os.cpu_count() or 1):
            condition = waiting.pop(0)
            under_way[attacked(session, condition)] = condition
        child, status = os.wait()
        condition = under_way.pop(child)
        if condition is None:
            if os.waitstatus_to_exitcode(status) != 1:
                raise pytest.UsageError("a test fails though no condition is left out")
        elif status:
            module, function, left_out = condition
            where = f"{module.__file__}:{left_out.lineno}"
            missed.append(f"{where}: {function.name} without `{ast.unparse(left_out.test)}`")
    print(f"\n{count} conditions of rules, each left out: {count - len(missed)} attacks succeeded")
    if missed:
        raise pytest.UsageError("no attack asks for\n" + "\n".join(sorted(missed)))
    return True
