"""What are the mass, damping and stiffness of a device with an arm?

The device is a mass $m_D$ with a damper $b_D$; the arm that holds it is a mass $m_H$ with a damper
$b_H$ and a spring $k_H$ to the resting posture. Which single mass, damper and spring replace
device and arm, and which model remains if nothing is assumed about the arm?
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import F_E


def derive(page):
    device = Plant(m_D, b_D, None).characteristic
    arm = Plant(m_H, b_H, k_H).characteristic
    page.say(
        "A firm grip couples device and arm rigidly. They have the same position, and the force "
        "between them acts on them with opposite signs. This force cancels in the sum of the "
        "two equations of motion, so masses, dampings and stiffnesses add up."
    )
    both = page.step(
        "Two bodies with the same position act as one mass, one damper and one spring",
        device + arm,
        (m_D + m_H) * s**2 + (b_D + b_H) * s + k_H,
        paper="2",
        because="the forces that the two bodies need for the same motion add up",
    )
    page.say(
        "The sum is the polynomial $ms^2+bs+k$ of a single body. Its mass, damping and "
        "stiffness are the coefficients of $s^2$, $s$ and 1. Without a model of the arm, the "
        "external force contains the whole action of the arm. The device then keeps its own "
        "mass and damping and has no spring."
    )
    mass, damping, stiffness = Poly(both, s).all_coeffs()
    page.settle("eq2", Eq(m, mass), Eq(b, damping), Eq(k, stiffness), definition=True)
    mass, damping, stiffness = Poly(device, s).all_coeffs()
    page.settle(
        "eq3", Eq(m, mass), Eq(b, damping), Eq(k, stiffness, evaluate=False), definition=True
    )
    page.say("This model is as general as (2), because the external force is arbitrary:")
    page.step(
        "The arm's forces can be counted as external",
        both * x - F_E,
        device * x - (F_E - arm * x),
        because="for the common motion, the left and the right side vanish, and the last "
        "bracket is the force on the device alone",
    )
    _settle(page)


def _settle(page):
    """(2) with F_E and (3) with F_E less the force on the arm give the same motion."""
    symbols, _, then = taken_apart(page.claim("s2d-arm-in-force"))
    together, alone = then.of
    there, back = (
        combined(wanted, [assume(known), S.One])
        for known, wanted in ((together, alone), (alone, together))
    )
    same = either_way(there, back, together, alone)
    page.settle("s2d-arm-in-force", same, example=dict.fromkeys(symbols, S.One))
