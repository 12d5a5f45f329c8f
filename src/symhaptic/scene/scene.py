"""The device, its arm and its loop in SI units, with the questions that may be asked of them.

A part that a scene leaves out is not set to zero: the model is derived without it.  Each method
imports the module that answers it.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, overload

from symhaptic.notation.quantities import number, shown
from symhaptic.scene.arms import checked
from symhaptic.scene.limit import Limit, Stiffness, one_or_many
from symhaptic.scene.loop import DeviceLoop

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

    from symhaptic.bounds.simplest.choose import Simplest
    from symhaptic.scene.arms import Arm
    from symhaptic.scene.damping import Damping, Dampings
    from symhaptic.scene.safe import Arms, SafeWalls
    from symhaptic.scene.simulation import Simulation
    from symhaptic.scene.walls import PassiveWalls, StableWalls


class Scene(DeviceLoop):
    """A haptic device in SI units, with its sampling period, its delay and the arm that holds it.

    Stability counts device and arm together, (2) of the paper.  Passivity counts the device alone,
    (3).  A part that is left out (``None``) is not modelled.  Walls have the stiffness K in N/m and
    the damping B in Ns/m.

    A rotary device has an ``inertia`` instead of a mass.  Then all stiffnesses are in N m/rad and
    all dampings in N m s/rad, wherever the methods say N/m and Ns/m.

    Numbers are in SI units.  Text has a number and a unit, such as ``"72 g"`` or ``"0.5 N*s/m"``.
    SI symbols with prefixes, deg, turn and rpm are accepted in any usual notation; with Pint, all
    units that it knows.

    Parameters
    ----------
    mass : float or str, optional
        m_D of the device in kg, > 0.
    inertia : float or str, optional
        Moment of inertia of a rotary device in kg m^2, > 0, instead of the mass.
    sampling_period : float or str, optional
        T in s, > 0.
    sampling_rate : float or str, optional
        1/T in Hz, > 0, instead of the sampling period, in which it is kept.
    damping : float, optional
        Physical damping b_D of the device in Ns/m, >= 0, without the arm's.
    stiffness : float, optional
        Physical stiffness of the device in N/m, >= 0, without the arm's.
    delay : float, optional
        Time t_d for computation and communication in s, >= 0.
    delay_samples : float, optional
        The delay d in sampling periods instead, >= 0.
    arm : Arm, optional
        The arm that holds the device.
    dynamics : LinearDevice, optional
        Any linear device, instead of mass, damping, stiffness and arm.
    velocity : LowPass, Average, Window, Filter, Measured, Oversampled or Difference, optional
        What the wall uses as the velocity; (x_k - x_(k-1))/T if left out, as in the paper.
    actuator : Lag, optional
        A lag between the command and the force.
    structure : SecondMass, optional
        A second mass on a spring.  The arm is on the motor's side of it.
    integrator : str
        ``"hold"`` for a device, ``"semi-implicit Euler"`` or ``"explicit Euler"`` for a simulator.
    virtual_mass : float, optional
        M in kg, >= 0, of a wall that adds M times the second difference over T^2.
    coupling : Coupling, optional
        A virtual coupling: a spring and a damper in series between device and wall.
    encoder : Encoder, optional
        Steps of the position sensor, for :meth:`max_quantised_stiffness` and :meth:`simulate`.
    coulomb_friction : float, optional
        f_c in N, >= 0, for the same.

    Raises
    ------
    ValueError
        If a mass, inertia, period or rate is not positive, a damping, stiffness or delay is
        negative, two of such a pair or two delays are given, or a value is infinite, NaN, a truth
        value or of the wrong dimension.

    Warns
    -----
    UserWarning
        If ``delay`` is longer than 100 periods.

    Notes
    -----
    In dimensionless numbers gamma = k T^2/m, delta = b T/m and d = t_d/T, with m, b and k of device
    and arm together.  Numbers become float64 and count as the decimals that they print as: a delay
    of 3e-4 s is exactly three periods of 1e-4 s, and so is one of 3 * 1e-4 s, which is
    0.00030000000000000003.  Quantities of Pint are converted.

    Examples
    --------
    >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.001)
    >>> scene.dimensionless
    Dimensionless(gamma=0.0, delta=0.005, delay=1.0)
    >>> scene.parts.name
    'damping, virtual damping, delay'
    >>> knob = Scene(inertia="2e-4 kg m^2", damping="1e-4 N m s/rad", sampling_rate="1 kHz")
    >>> knob.is_stable(K="1 N m/deg", B="0.05 N m s/rad"), round(knob.max_passive_stiffness(), 9)
    (True, 0.2)
    """

    @classmethod
    def of(cls, device: str, **given: Any) -> Scene:
        """Scene with a published device.

        Parameters
        ----------
        device : str
            A name that :meth:`devices` lists.
        **given
            Arguments of :class:`Scene`: the sampling period, the delay, and values of the device
            that are not published.  They override published values.

        Returns
        -------
        Scene
            The device with its published mass and damping.

        Raises
        ------
        ValueError
            If the name is unknown, or if neither ``given`` nor the source has a mass.

        Examples
        --------
        >>> Scene.of("Phantom Premium 1.5", sampling_period=0.001, delay_samples=1.5).damping
        0.005
        """
        from symhaptic.scene import arms

        known = {**arms.of_device(device), **given}
        if "mass" not in known:
            name = arms.device(device).name
            raise ValueError(f"mass: is not published of the {name}; give one in kg")
        return cls(**known)

    @staticmethod
    def devices() -> dict[str, dict[str, float | str | None]]:
        """Published data of devices.

        Returns
        -------
        dict of dict
            By the name of the device: ``mass`` in kg, ``damping`` in Ns/m, ``K`` in N/m, ``B`` in
            Ns/m and ``source``.  K and B are the largest values that a driver or a course
            recommends. ``None`` means not published.

        Examples
        --------
        >>> Scene.devices()["Novint Falcon"]["K"]
        3000.0
        """
        from symhaptic.scene.arms import published

        return published()

    def held_by(self, arm: Arm) -> Scene:
        """The same device, coupled to an arm.

        Parameters
        ----------
        arm : Arm
            The arm.  One that was measured together with its device (``with_device=True``) takes
            the device's place for stability.

        Returns
        -------
        Scene
            For stability, the arm's mass, damping and stiffness are added to the device, (2).  For
            passivity, the arm is ignored, (3).

        Raises
        ------
        ValueError
            If ``arm`` is not an :class:`symhaptic.Arm`, or if the scene has an arm already.

        Examples
        --------
        >>> from symhaptic import Arm
        >>> alone = Scene(mass=0.072, damping=0.005, sampling_period=0.001)
        >>> held = alone.held_by(Arm.of("Lawrence and Chapel"))
        >>> held.coupled
        Coupled(mass=0.572, damping=6.005, stiffness=40.0)
        >>> held.damping, held.max_passive_stiffness() == alone.max_passive_stiffness()
        (0.005, True)
        """
        if self.arm is not None:
            raise ValueError(
                f"arm: {shown(arm)} would be a second arm beside {self.arm!r}; "
                "use scene.device.held_by(...) for another arm"
            )
        return replace(self, arm=checked(arm, self.rotary))

    def is_stable(self, K: ArrayLike, B: ArrayLike, *, certified: bool = False) -> Any:
        """Whether the loop with a wall is stable, of device and arm together.

        Parameters
        ----------
        K, B : float, str or array_like
            Stiffness in N/m and damping in Ns/m of the walls, finite.  Arrays broadcast; they may
            be those of xarray, Dask, pandas and Pint.
        certified : bool, optional
            Give a verdict that is right for the decimals that were given, none of them rounded, in
            ball arithmetic.  It takes about 0.3 ms per wall.

        Returns
        -------
        bool or array of bool
            A truth value for numbers, an array of the same library for arrays.  NaN is not stable.
            For a device, an arm and a delay, True is always right, and False is wrong only for
            some stable walls within rounding of the boundary.  With further parts of the loop
            both may be wrong there.

        Raises
        ------
        ValueError
            If ``K`` or ``B`` is infinite or has a unit that cannot be converted, or if a verdict on
            a loop with more than a device, an arm and a delay is to be ``certified``.
        ArithmeticError
            If ``certified`` is true and a wall is on the boundary, or too close to it for balls
            to decide.

        See Also
        --------
        symhaptic.is_stable : The same in dimensionless parameters.

        Examples
        --------
        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.0015)
        >>> scene.is_stable([249, 252], B=0.0).tolist()
        [True, False]
        """
        from symhaptic.scene.walls import is_stable

        return is_stable(self, K, B, certified)

    def is_passive(self, K: ArrayLike, B: ArrayLike, *, certified: bool = False) -> Any:
        """Whether no motion of the device extracts energy from a wall.

        Parameters
        ----------
        K, B : float, str or array_like
            Stiffness in N/m and damping in Ns/m of the walls, finite.  Arrays broadcast; they may
            be those of xarray, Dask, pandas and Pint.
        certified : bool, optional
            Give a verdict that is right for the decimals that were given, none of them rounded, in
            ball arithmetic.  It takes about 0.3 ms per wall.

        Returns
        -------
        bool or array of bool
            Whether :meth:`passivity_margin` is not negative.  The device alone counts, (3); an arm
            is ignored.

        Raises
        ------
        ValueError
            If ``K`` or ``B`` is infinite or has a unit that cannot be converted, or if a verdict on
            a loop with more than a device, an arm and a delay is to be ``certified``.
        ArithmeticError
            If ``certified`` is true and a wall is on the boundary, or too close to it for balls
            to decide.

        Examples
        --------
        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001)
        >>> scene.is_passive(999.0, 0.0)  # 2 b/T
        True
        >>> scene.is_passive([1000.0, 1000.0000000001], 0.0, certified=True).tolist()
        [True, False]
        """
        from symhaptic.scene.walls import is_passive

        return is_passive(self, K, B, certified)

    def passivity_margin(self, K: ArrayLike, B: ArrayLike) -> Any:
        """Damping of the device minus the damping that a wall requires.

        Parameters
        ----------
        K, B : float, str or array_like
            Stiffness in N/m and damping in Ns/m of the walls, finite.  Arrays broadcast; they may
            be those of xarray, Dask, pandas and Pint.

        Returns
        -------
        float or array
            The margin in Ns/m.  Negative for a wall that is not passive, and -inf for ``K`` < 0.
            The device alone counts, (3); an arm is ignored.

        Raises
        ------
        ValueError
            If ``K`` or ``B`` is infinite or has a unit that cannot be converted.

        Examples
        --------
        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001)
        >>> round(scene.passivity_margin(400.0, 0.0), 9)  # b - K T/2
        0.3
        """
        from symhaptic.scene.walls import passivity_margin

        return passivity_margin(self, K, B)

    def stability_boundary(self, frequency_hz: ArrayLike) -> tuple[Any, Any]:
        """Walls with which the loop oscillates at a frequency.

        Parameters
        ----------
        frequency_hz : array_like
            Frequencies in Hz, between 0 and 1/(2 T).

        Returns
        -------
        K, B : float or array
            Stiffness in N/m and damping in Ns/m.  NaN gives NaN.

        Raises
        ------
        ValueError
            If a frequency is not between 0 and 1/(2 T).

        Notes
        -----
        Not every such wall lies on the border of the stable region, see :meth:`stable_region`.

        Examples
        --------
        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.0015)
        >>> K, B = scene.stability_boundary(scene.max_stable_stiffness().frequency_hz)
        >>> round(K), round(B, 1)
        (9275, 34.5)
        """
        from symhaptic.scene.walls import stability_boundary

        return stability_boundary(self, frequency_hz)

    def stable_region(self) -> StableWalls:
        """All stable walls as a region of the plane of K in N/m and B in Ns/m.

        Returns
        -------
        StableWalls
            With ``outline``, ``area``, ``contains``, ``max_stiffness`` and further limits.

        Raises
        ------
        ValueError
            If the delay is longer than 100 000 sampling periods.

        Examples
        --------
        >>> region = Scene(mass=0.1, sampling_period=0.001).stable_region()
        >>> round(region.max_stiffness.K, 3), region.contains(1000.0, 5.0)
        (68629.15, True)
        """
        from symhaptic.scene.walls import stable_region

        return stable_region(self)

    def passive_region(self) -> PassiveWalls:
        """All passive walls as a region of the plane of K in N/m and B in Ns/m.

        Returns
        -------
        PassiveWalls
            With ``outline``, ``area``, ``contains`` and ``max_stiffness``.  The device alone
            counts, (3).  Empty if the device has no damping.

        Examples
        --------
        >>> region = Scene(mass=0.1, damping=0.5, sampling_period=0.001).passive_region()
        >>> round(region.area, 3), region.contains(400.0, 0.2)  # a triangle, b times 2 b/T
        (500.0, True)
        """
        from symhaptic.scene.walls import passive_region

        return passive_region(self)

    @overload
    def max_stable_stiffness(self, B: float | None = None) -> Stiffness: ...
    @overload
    def max_stable_stiffness(self, B: ArrayLike) -> Limit: ...
    def max_stable_stiffness(self, B: ArrayLike | None = None) -> Stiffness | Limit:
        """Largest stiffness of a stable wall, of any damping or of a given one.

        Parameters
        ----------
        B : float, str or array_like, optional
            Virtual damping in Ns/m, finite.  If left out, the damping with the largest limit is
            taken.

        Returns
        -------
        Stiffness or Limit
            A number in N/m with two attributes: the required virtual damping ``B`` in Ns/m, and
            ``frequency_hz``, at which the loop begins to oscillate.  For an array ``B`` a tuple of
            the arrays ``K``, ``B`` and ``frequency_hz``, as of :meth:`limit_at`.

        Raises
        ------
        ValueError
            If ``B`` is not a finite number, or if pieces of the boundary are missed, see
            :func:`symhaptic.stable_region`.

        Notes
        -----
        The limit is a supremum.  With any damping except ``.B`` it is lower.  With a filter, the
        stable region may have its largest stiffness in a corner; softer walls with the damping
        ``.B`` are then unstable.  Test the wall that you choose with :meth:`is_stable`.

        Examples
        --------
        >>> scene = Scene(mass=0.1, sampling_period=0.001)  # 4 (2 - r)(r - 1)/r m/T^2, r = sqrt 2
        >>> stiffest = scene.max_stable_stiffness()
        >>> round(stiffest, 3), round(stiffest.B, 3)
        (68629.15, 82.843)
        >>> round(scene.max_stable_stiffness(B=5.0), 3)  # 2 B (2 m - B T)/(T (2 m + B T))
        9512.195
        """
        from symhaptic.scene.walls import limit_at, max_stable_stiffness

        return max_stable_stiffness(self) if B is None else one_or_many(limit_at(self, B))

    @overload
    def max_passive_stiffness(self, B: float | None = None) -> Stiffness: ...
    @overload
    def max_passive_stiffness(self, B: ArrayLike) -> Limit: ...
    def max_passive_stiffness(self, B: ArrayLike | None = None) -> Stiffness | Limit:
        """Largest stiffness of a passive wall, of any damping or of a given one.

        Parameters
        ----------
        B : float, str or array_like, optional
            Virtual damping in Ns/m, finite.  If left out, the damping with the largest limit is
            taken.

        Returns
        -------
        Stiffness or Limit
            A number in N/m with the attributes ``B`` in Ns/m and ``frequency_hz``, the worst
            frequency. For an array ``B`` a tuple of the arrays ``K``, ``B`` and ``frequency_hz``.
            NaN if no wall of this damping is passive.  The device alone counts, (3); an arm is
            ignored.

        Raises
        ------
        ValueError
            If ``B`` is not a finite number.

        Examples
        --------
        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001)
        >>> round(scene.max_passive_stiffness(), 6)  # 2 b/T
        1000.0
        >>> round(scene.max_passive_stiffness(B=0.2), 6)  # 2 (b - B)/T
        600.0
        """
        from symhaptic.scene.walls import max_passive_stiffness, passive_limit_at

        return max_passive_stiffness(self) if B is None else one_or_many(passive_limit_at(self, B))

    def max_quantised_stiffness(self) -> Stiffness:
        """Largest stiffness in N/m of a wall without damping that is passive with the encoder.

        The encoder rounds the position, and an oscillation between its steps can last although the
        loop with the exact position is stable and passive.  Coulomb friction dissipates what the
        rounding adds.  The limit is 0 without Coulomb friction: then the steps can sustain an
        oscillation at any stiffness.  Counts the device alone, (3); an arm is ignored.

        Returns
        -------
        Stiffness
            The stiffness with the attributes ``.B``, 0.0, and ``.frequency_hz``, NaN if friction
            limits it.  :meth:`describe` says which of the two does.  NaN if a virtual mass alone
            is not passive.

        Raises
        ------
        ValueError
            If the scene has no encoder, or parts for which passivity is not known.

        Notes
        -----
        Without delay K <= min(2 b/T, 2 f_c/Delta) [1]_, with the friction f_c and the resolution
        Delta.  With a delay, :meth:`max_passive_stiffness` for B = 0 takes the place of 2 b/T.  A
        virtual mass M takes 4 M/T^2 from the limit by friction.
        The bound is sufficient for passivity; :meth:`simulate` shows motions beyond it.

        .. [1] J. J. Abbott and A. M. Okamura, "Effects of position quantization and sampling rate
           on virtual-wall passivity", IEEE Transactions on Robotics 21(5), 2005, pp. 952-964.

        Examples
        --------
        >>> from symhaptic import Encoder
        >>> course = Scene(mass="40 g", damping=0.8, sampling_rate="1 kHz",
        ...     encoder=Encoder(resolution="61.4 um"), coulomb_friction="0.02 N")
        >>> round(course.max_quantised_stiffness(), 1)  # 2 f_c/Delta; 2 b/T is 1600 N/m
        651.5
        """
        from symhaptic.scene.walls import max_quantised_stiffness

        return max_quantised_stiffness(self)

    def limit_at(self, B: ArrayLike) -> Limit:
        """Largest stiffness of a stable wall with a given damping.

        Parameters
        ----------
        B : float, str or array_like
            Virtual damping in Ns/m, finite.  Arrays may be those of xarray, Dask, pandas and Pint.

        Returns
        -------
        Limit
            ``K`` in N/m, ``B`` in Ns/m and ``frequency_hz``, at which the loop oscillates at this
            limit; arrays for an array ``B``.  K is NaN if no stiffness makes a wall of this damping
            stable.

        Raises
        ------
        ValueError
            If ``B`` is not a finite number, or if pieces of the boundary are missed, see
            :func:`symhaptic.stable_region`.

        Notes
        -----
        K is a supremum, found among the crossings of the explicit boundary.  There may also be a
        lower limit.

        Examples
        --------
        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.0015)
        >>> round(scene.limit_at(B=0.0).K, 1)
        250.4
        """
        from symhaptic.scene.walls import limit_at

        return limit_at(self, B)

    @overload
    def damping_for(self, K: float) -> Damping: ...
    @overload
    def damping_for(self, K: ArrayLike) -> Dampings: ...
    def damping_for(self, K: ArrayLike) -> Damping | Dampings:
        """Virtual damping B in Ns/m with which a wall of stiffness ``K`` tolerates the most delay.

        Parameters
        ----------
        K : float, str or array_like
            Virtual stiffness in N/m.  Arrays may be those of xarray, Dask, pandas and Pint.

        Returns
        -------
        Damping or Dampings
            For one stiffness a number, B, with the attributes ``intervals``, the lowest and the
            highest B of each range of stable dampings, and ``delay_margin`` in s.  For an array a
            tuple of arrays: ``B``, ``low`` and ``high``, the ends of the range that contains B, and
            ``delay_margin``.  If no damping makes a stable wall, B is NaN, ``intervals`` is empty
            and the margin 0.

        Raises
        ------
        ValueError
            If ``K`` is not finite, or if pieces of the boundary are missed, see
            :func:`symhaptic.stable_region`.

        Notes
        -----
        The delay margin is that of :meth:`delay_margin`: the wall stays stable if a velocity
        filter, an amplifier or a bus delays the loop by less.  The ends of the ranges lie on the
        explicit stability boundary, and between them the roots outside the unit circle are counted.
        B is found by a search over these ranges, to about 1e-5 of their width.  If several dampings
        tolerate every delay, B is in the middle of them.  If the margin is not computed (NaN, see
        :meth:`delay_margin`), B is the middle of the widest range.

        See Also
        --------
        limit_at : Largest stiffness for a damping.

        Examples
        --------
        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.0015)
        >>> best = scene.damping_for(K=1000.0)
        >>> [(round(low, 2), round(high, 2)) for low, high in best.intervals]
        [(1.54, 63.67)]
        >>> round(best, 1), round(1000 * best.delay_margin, 2)  # Ns/m, ms
        (11.9, 5.17)
        >>> scene.damping_for(K=[1000.0, 20_000.0]).B.round(1).tolist()
        [11.9, nan]
        """
        from symhaptic.scene.damping import damping_for

        return damping_for(self, K)

    def sensitivity(self, B: float | None = None) -> dict[str, float]:
        """Change of the stiffness limit, in percent, for a 1 % increase of each parameter.

        Parameters
        ----------
        B : float, optional
            Virtual damping in Ns/m; the limit is then :meth:`limit_at`, otherwise
            :meth:`max_stable_stiffness`.

        Returns
        -------
        dict of str to float
            By the name of the parameter.  A parameter that is left out or 0 has no entry.  The
            arm's parameters are ``arm_mass``, ``arm_damping`` and ``arm_stiffness``, and those of
            parts are named in the same way, such as ``velocity_cutoff`` or ``structure_mass``.
            Integers and the coefficients of a ``Filter`` or of ``dynamics`` have no entry.

        Notes
        -----
        When the sampling period changes, a delay given in s stays constant in s, and a delay given
        in periods stays constant in periods.  The delay of a simulator is always whole periods.
        Computed by differences, to about 1e-6.

        Examples
        --------
        >>> scene = Scene(mass=0.1, sampling_period=0.001, delay_samples=1)
        >>> {name: round(x, 3) for name, x in scene.sensitivity().items()}
        {'mass': 1.0, 'sampling_period': -2.0, 'delay_samples': -1.078}
        """
        from symhaptic.scene.walls import sensitivity

        return sensitivity(self, B)

    def describe(self) -> str:
        """The scene and its limits in words, with units.

        Returns
        -------
        str
            One line per parameter and limit.  Stability counts device and arm together, passivity
            the device alone.

        Examples
        --------
        >>> print(Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.0015).describe())
        mass             0.1 kg
        damping          0.5 Ns/m
        sampling period  0.001 s
        delay            0.0015 s, 1.5 sampling periods
        stable up to     9275 N/m with B = 34.48 Ns/m, at 69.48 Hz
        without B        250.4 N/m, at 7.945 Hz
        passive up to    328.9 N/m with B = 0.2027 Ns/m, at 97.76 Hz
        """
        from symhaptic.scene.words import facts, lines

        return lines(facts(self))

    def _repr_html_(self) -> str:
        from symhaptic.scene.words import facts, table

        return table(facts(self))

    def _repr_latex_(self) -> str:
        from symhaptic.scene.words import latex

        return latex(self)

    def plot(
        self,
        K: float | None = None,
        B: float | None = None,
        *,
        arm: Arm | None = None,
        axes: Axes | None = None,
    ) -> Axes:
        """Draw the stable and the passive walls, K from left to right and B upwards.

        Parameters
        ----------
        K, B : float or str, optional
            A wall in N/m and Ns/m that is marked, with its distance to the stiffness limit.
        arm : Arm, optional
            An arm for the stable walls, instead of that of the scene.  Passive walls are those of
            the device alone.
        axes : matplotlib.axes.Axes, optional
            Axes to draw into.

        Returns
        -------
        matplotlib.axes.Axes
            ``axes``, or those of a new figure that fits a column of 3.5 in and is saved with Type
            42 fonts.

        Raises
        ------
        ValueError
            If only one of ``K`` and ``B`` is given.

        Examples
        --------
        >>> axes = Scene(mass=0.1, damping=2.0, sampling_period=1e-3).plot(K=4000.0, B=20.0)
        >>> axes.get_xlabel()
        'virtual stiffness $K$ in N/m'
        >>> axes.figure.savefig("walls.pdf")  # doctest: +SKIP
        """
        from symhaptic.scene.picture import draw, new_axes

        if (K is None) != (B is None):
            raise ValueError(f"K: {K!r} with B={B!r} is no wall; give both or neither")
        wall = None
        if K is not None and B is not None:
            wall = number("K", K, self.unit("N/m")), number("B", B, self.unit("N*s/m"))
        axes = axes if axes is not None else new_axes("Scene.plot")
        draw(axes, self.held_by(arm) if arm else self, wall)
        return axes

    def safe_walls(self, arm: Arms = None) -> SafeWalls:
        """Walls (K, B) that are proved stable for every arm of a range, and passive walls.

        Takes some seconds.

        Parameters
        ----------
        arm : ArmRange, Arm or several Arms, optional
            The range of arms; several arms include all arms between them.  If left out, the scene's
            own arm, or else the range (23) of the paper: 0 kg (no arm) to 23 kg, up to 1000 N/m
            and 20 Ns/m per kg.

        Returns
        -------
        SafeWalls
            With ``contains``, ``is_passive``, ``max_stiffness`` and the outline of the proved
            walls.

        Raises
        ------
        ValueError
            If ``arm`` has another type, if the scene already has an arm, or if no wall is proved.

        Notes
        -----
        The proof encloses the loops by interval arithmetic, and a second check confirms its
        certificate.  Delays may be integer or fractional, up to 60 periods.  The proved limits are
        below the true ones: by about 1 % for short delays, by 10 % and more for delays of 5 to 50
        ms.

        Examples
        --------
        >>> from symhaptic import Arm
        >>> device = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.0015)
        >>> safe = device.safe_walls(arm=Arm(mass=0.8, damping=5.5, stiffness=568))
        >>> safe.contains(K=20_000.0, B=100.0), safe.contains(K=2000.0, B=0.0)
        (True, True)
        >>> safe.is_passive(K=100.0, B=0.0)
        True
        """
        from symhaptic.scene.safe import safe_walls

        self.refuse_further("safe_walls, whose proofs are of the paper's loop")
        return safe_walls(self, arm)

    def simplest(
        self,
        rtol: float,
        *,
        mass: float | tuple[float, float] | None = None,
        inertia: float | tuple[float, float] | None = None,
        damping: float | tuple[float, float] | None = None,
        stiffness: float | tuple[float, float] | None = None,
        B: float | tuple[float, float] | None = None,
    ) -> Simplest:
        """The smallest model whose stiffness limit is proved to be within ``rtol`` of the scene's.

        Parameters
        ----------
        rtol : float
            Largest relative error ``|K_model/K - 1|``, > 0.
        mass, inertia, damping, stiffness : float or (float, float), optional
            Parameters of device and arm together, in SI units, instead of the scene's: a number, or
            a range (lowest, highest) over which the bound holds.
        B : float or (float, float), optional
            Virtual damping in Ns/m.  The limit is then the largest stable stiffness with this
            damping, otherwise :meth:`max_stable_stiffness`.

        Returns
        -------
        Simplest
            All models with their proved bounds.  A model without a proof has an infinite bound,
            with the reason.

        Raises
        ------
        ValueError
            If ``rtol`` is not positive, or if a range is impossible.

        Notes
        -----
        The models are, the smallest first: the linear limit (25) (only with ``B``, because it grows
        with ``B``), the loop without spring and damper, without spring, without damper, and the
        full loop.

        Both K are tips of stability boundaries.  Without delay a tip is proved to be the largest
        stable stiffness; with a delay it is proved that no stable wall is stiffer.  Bounds are
        proved by ball (interval) arithmetic, for integer delays.  Numbers count as the decimals
        that they print as.

        Examples
        --------
        >>> arm = Scene(mass=1.0, damping=2.0, stiffness=50.0, sampling_period=0.001, delay=0.001)
        >>> print(arm.simplest(0.01, damping=(0.0, 20.0)))
          linear limit: not proved: it has no largest stiffness, but grows with B; give B
          without stiffness and damping: below 6.66 %
        * without stiffness: below 0.0169 %
          without damping: below 6.68 %
          full: exact
        """
        from symhaptic.bounds.simplest.choose import Loop, simplest

        self.refuse_further("simplest, whose proofs are of the paper's loop")
        if self.rotary and mass is not None:
            raise ValueError("mass: this device has an inertia; give inertia=")
        if not self.rotary and inertia is not None:
            raise ValueError("inertia: this device has a mass; give mass=")
        over = {"mass": mass, "inertia": inertia, "damping": damping}
        m, b, k = self.coupled
        loop = Loop(self.parts, self.periods, self.sampling_period, m, k, b, self.unit)
        return simplest(loop, rtol, {**over, "stiffness": stiffness, "B": B})

    def to_control(self) -> Any:
        """The sampled device with its arm and its delay as a transfer function of python-control.

        Returns
        -------
        control.TransferFunction
            From the force in N to the position in m, with the sampling period as ``dt``.

        Raises
        ------
        ModuleNotFoundError
            If python-control is not installed.

        Examples
        --------
        >>> system = Scene(mass=1.0, sampling_period=1.0).to_control()
        >>> len(system.poles())
        2
        """
        from symhaptic.scene.systems import control_system

        return control_system(self)

    def to_scipy(self) -> Any:
        """The sampled device with its arm and its delay as a ``scipy.signal.dlti``.

        Returns
        -------
        scipy.signal.TransferFunction
            From the force in N to the position in m.

        Examples
        --------
        >>> system = Scene(mass=1.0, sampling_period=1.0, delay=0.5).to_scipy()
        >>> system.num.tolist(), system.den.tolist()
        ([0.125, 0.75, 0.125], [1.0, -2.0, 1.0, 0.0])
        """
        from symhaptic.scene.systems import scipy_system

        return scipy_system(self)

    def to_sympy(self) -> Any:
        """The sampled device with its arm and its delay as a SymPy ``TransferFunction``.

        Returns
        -------
        sympy.physics.control.TransferFunction
            From the force in N to the position in m, with rational coefficients.

        Examples
        --------
        >>> Scene(mass=1.0, sampling_period=1.0).to_sympy().num.as_poly().all_coeffs()
        [1/2, 1/2]
        """
        from symhaptic.scene.systems import sympy_system

        return sympy_system(self)

    def simulate(
        self,
        K: float | str,
        B: float | str,
        *,
        duration: float | str,
        position0: float | str = 0.0,
        velocity0: float | str = 0.0,
        external_force: float | str | ArrayLike | Callable[[float], float] = 0.0,
        unilateral: bool = False,
        saturation: float | str | None = None,
        samples_between: int = 0,
    ) -> Simulation:
        """Simulate the device at a wall at position 0, exactly at and between the samples.

        The wall is switched on at time 0; commands that are still delayed then are 0.  Before, the
        device moved with ``velocity0``.  Device and arm move together, with all parts, the
        encoder's resolution and the Coulomb friction of the scene.

        Parameters
        ----------
        K, B : float or str
            Stiffness in N/m and damping in Ns/m of the wall.
        duration : float or str
            In s, > 0; rounded up to whole sampling periods.
        position0, velocity0 : float or str
            Start in m and m/s.  A device that is released inside the wall has ``position0`` > 0;
            one that is thrown against it has ``position0`` <= 0 and ``velocity0`` > 0.
        external_force : float, str, array_like of shape (periods,), or callable
            Force in N on the device, or on the second mass of a ``structure``.  It is held for each
            sampling period; a function of the time in s is called at the samples.
        unilateral : bool
            ``False`` for a wall that is a spring and a damper everywhere, as the verdicts assume.
            ``True`` for a wall at positions > 0 that only pushes, towards negative positions.
        saturation : float or str, optional
            Largest force in N that the controller commands, >= 0.
        samples_between : int
            Number of additional times between two samples, >= 0; 0 for a simulator's integrator.

        Returns
        -------
        Simulation
            Arrays of shape (n,) with n = periods (``samples_between`` + 1) + 1.  If the motion
            grows beyond the range of floats, values are not finite from there on.  Energies of a
            device that is given as ``dynamics`` are NaN.

        Raises
        ------
        ValueError
            If an argument is not finite, out of its range or of the wrong dimension or shape, and
            for a start or Coulomb friction beside ``dynamics``.

        Notes
        -----
        Between the samples the forces are held, and matrix exponentials give the motion.  A
        fractional delay changes the force within a period.  Coulomb friction is constant while the
        device slides; the instants at which it stops and breaks away are computed as roots of power
        series.  It acts on the motor.  A simulator moves by the steps of its integrator, and
        friction takes at most the velocity of a step.

        Examples
        --------
        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.0015)
        >>> limit = scene.limit_at(B=5.0).K
        >>> for K in (0.9 * limit, 1.1 * limit):
        ...     found = scene.simulate(K, 5.0, duration="2 s", position0="1 mm")
        ...     print(f"{K:.0f} N/m: {1000 * abs(found.position[-100:]).max():.2g} mm")
        2323 N/m: 0.004 mm
        2840 N/m: 2.8e+02 mm
        """
        from symhaptic.scene.simulation import simulate

        return simulate(
            self,
            K,
            B,
            duration=duration,
            position0=position0,
            velocity0=velocity0,
            external_force=external_force,
            unilateral=unilateral,
            saturation=saturation,
            samples_between=samples_between,
        )

    def delay_margin(self, K: ArrayLike, B: ArrayLike) -> Any:
        """Delay that may be added until the loop with a wall is unstable.

        Parameters
        ----------
        K, B : float, str or array_like
            Stiffness in N/m and damping in Ns/m of the walls, finite.  Arrays broadcast; they may
            be those of xarray, Dask, pandas and Pint.

        Returns
        -------
        float or array
            The margin in s.  The wall is stable for every delay from the scene's own up to its own
            plus the margin.  0 for a wall that is unstable at the scene's delay.  NaN (not
            computed) for a wall that is stable there but not at every smaller delay, unless the
            scene has further parts.

        Raises
        ------
        ValueError
            If ``K`` or ``B`` is infinite or has a unit that cannot be converted.

        See Also
        --------
        max_delay : The largest total delay.

        Examples
        --------
        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.0015)
        >>> round(1000 * scene.delay_margin(K=1000.0, B=5.0), 3)  # ms
        2.901
        """
        from symhaptic.scene.walls import delay_margin

        return delay_margin(self, K, B)

    def stable_delays(self, K: float, B: float, *, up_to: float) -> tuple[tuple[float, float], ...]:
        """All windows of the delay in which a wall is stable, from 0 to ``up_to``.

        A longer delay may make an unstable wall stable: stiff devices have several windows.

        Parameters
        ----------
        K, B : float
            Stiffness in N/m and damping in Ns/m of the wall.
        up_to : float
            The longest delay in s, up to 20 000 sampling periods.

        Returns
        -------
        tuple of tuple of float
            The ends of each window in s, which are open except at 0 and ``up_to``.

        Raises
        ------
        ValueError
            If an argument is not a finite number, ``up_to`` is negative or too long, or the scene
            is a simulator, which has no time between its steps.

        Examples
        --------
        >>> scene = Scene(mass=0.1, damping=1.0, stiffness=3e5, sampling_period=0.001)
        >>> windows = scene.stable_delays(K=8e4, B=-90.0, up_to=0.008)
        >>> [(round(1000 * low, 3), round(1000 * high, 3)) for low, high in windows]  # ms
        [(0.533, 1.694), (4.783, 4.928)]
        """
        from symhaptic.scene.walls import stable_delays

        return stable_delays(self, K, B, up_to)

    def max_delay(self, K: ArrayLike, B: ArrayLike) -> Any:
        """Largest delay up to which the loop with a wall is stable.

        Parameters
        ----------
        K, B : float, str or array_like
            Stiffness in N/m and damping in Ns/m of the walls, finite.  Arrays broadcast; they may
            be those of xarray, Dask, pandas and Pint.

        Returns
        -------
        float or array
            The delay in s.  The wall is stable for every delay from 0 to this one; the scene's own
            delay is ignored.  0 for a wall that is unstable without delay.

        Raises
        ------
        ValueError
            If ``K`` or ``B`` is infinite or has a unit that cannot be converted.

        Examples
        --------
        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.0015)
        >>> round(1000 * scene.max_delay(K=1000.0, B=5.0), 3)  # ms
        4.401
        """
        from symhaptic.scene.walls import max_delay

        return max_delay(self, K, B)
