"""An export for whole delays alone has nothing of what serves fractions, and none is inside it."""

import numpy as np
import pytest
from export.covering import one_of
from export.test_targets import run_all

from symhaptic.export import request
from symhaptic.export.language import Refused
from symhaptic.export.targets import TARGETS
from symhaptic.kernels import haptic

FORMS = request.chosen([], delay=1, whole_delays=True)
FRACTIONAL = (
    "fractional_roots",
    "FractionalRoots",
    "turn(",
    "passive_angle(",
    "kick(",
    "early_angle",
    "rising(",
)


def test_the_form_of_a_fraction_is_left_out_and_refused_by_name():
    assert "discretize_fractional" not in [form.name for form in FORMS]
    with pytest.raises(Refused, match="--whole-delays: discretize_fractional: needs fractional"):
        request.chosen(["discretize_fractional"], whole_delays=True)
    with pytest.raises(Refused, match="--whole-delays: the scene has no delay"):
        request.chosen([], request.scene("no-delay"), whole_delays=True)


@pytest.mark.slow
@pytest.mark.parametrize("language", one_of(TARGETS, "numpy", "c", "fortran", "javascript"))
def test_the_self_test_passes_and_asks_a_fraction_too(language, tmp_path):
    """In every language its vectors have d = 1.5 among what is outside."""
    names = ["is_stable", "unstable_roots", "stability_boundary", "max_passive_stiffness"]
    names += ["passivity_margin", "max_stable_stiffness"]
    forms = request.chosen(names, whole_delays=True)
    _, files = request.built(TARGETS[language], forms)
    source = "".join(t for n, t in files.items() if n not in ("vectors.txt", "README.md"))
    assert not [word for word in FRACTIONAL if word in source]
    assert files["vectors.txt"].count("0x1.8000000000000p+0 nan") == 4
    request.write(files, tmp_path / "out")
    assert run_all(TARGETS[language], "haptic", tmp_path / "out").split()[2] == "0"


def test_whole_delays_are_what_they_are_with_fractions():
    _, files = request.built(TARGETS["numpy"], FORMS, vectors=False)
    space = {}
    exec(files["haptic.py"], space)
    rng = np.random.default_rng(7)
    given = {"gamma": rng.uniform(0, 5, 60), "delta": rng.uniform(0, 5, 60), "alpha": 0.4,
             "theta": rng.uniform(0.1, 1, 60), "beta": 0.2,
             "d": rng.choice([0.0, 1.0, 2.0], 60)}  # fmt: skip
    for form in FORMS:
        if form.name not in vars(haptic) or "d" not in {s.name for s in form.arguments}:
            continue
        arguments = [given[s.name] for s in form.arguments]
        here = np.stack(np.atleast_1d(space[form.name](*arguments)))
        there = np.stack(np.atleast_1d(getattr(haptic, form.name)(*arguments)))
        assert np.allclose(here, there, rtol=1e-13, atol=1e-15, equal_nan=True), form.name
        late = [0.5 if s.name == "d" else given[s.name] for s in form.arguments]
        nothing = {"is_stable": 0.0, "unstable_roots": -1.0}.get(form.name, np.nan)
        found = np.stack(np.atleast_1d(space[form.name](*late))).astype(float)
        assert np.array_equal(found, np.full_like(found, nothing), equal_nan=True), form.name
