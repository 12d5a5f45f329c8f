import pytest


@pytest.fixture(params=[pytest.param(15, id="few"), pytest.param(2500, marks=pytest.mark.slow)])
def loops(request):
    """How many random loops are tried."""
    return request.param
