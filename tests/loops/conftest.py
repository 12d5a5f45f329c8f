import pytest


@pytest.fixture(params=[pytest.param(15, id="few"), pytest.param(300, marks=pytest.mark.slow)])
def walls(request):
    """How many random walls a loop is tried with."""
    return request.param
