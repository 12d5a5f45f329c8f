"""Which inequalities keep every root inside the unit circle?

The paper names Jury's criterion for the stable regions, but uses a grid, since the inequalities
soon become complicated. We look for few and small inequalities that are equivalent to stability,
for any polynomial. Half of Jury's determinants are sufficient if linear inequalities (half planes)
replace the others (Anderson and Jury, 1973).
"""

from sympy import Matrix, S, expand, symbols

from symhaptic.model import jury
from symhaptic.notation import s, x, y, z
from symhaptic.notation.latex import latex

DEGREES = range(2, 8)
"""The degrees at which polynomial arithmetic checks the general formulas."""


def derive(page):
    page.say(
        r"Let $p(z)=a_nz^n+\ldots+a_0$ be a real polynomial with $a_n>0$, and let $x=z+1/z$. On "
        r"the circle $x=2\cos\theta$. We add $p$ and its mirror image $z^np(1/z)$ and subtract "
        "them. For $n=2m$ the sum is $z^mF(x)$ and the difference $z^m(z-1/z)G(x)$; for $n=2m+1$ "
        "they are $z^m(z+1)F(x)$ and $z^m(z-1)G(x)$."
    )
    halves(page)
    page.say(
        r"On the circle, $z^{-n/2}p$ is $\tfrac12F+j\sin\theta\,G$ for even $n$ and "
        r"$\cos\tfrac\theta2\,F+j\sin\tfrac\theta2\,G$ for odd $n$. Let all roots lie inside. "
        r"Then the argument of every factor $z-z_i$ increases, and that of $p$ grows by $n\pi/2$ "
        r"over $0<\theta<\pi$. So $p$ crosses the imaginary axis ($n$ even) or the real axis ($n$ "
        "odd) $m$ times. At each crossing $F$ or $G$ has a root that is real and simple and has "
        "$|x|<2$. The direction of the crossing gives $F'G>0$ at the roots of $F$, and $FG'<0$ "
        "at the roots of $G$."
    )
    page.say(
        "Conversely, let all $m$ roots of $F$ or of $G$ have these properties, and let "
        "$p(1)>0$, and for odd $n$ also $G(2)>0$. The argument of $p$ starts at 0, crosses the "
        r"axis $m$ times in the positive direction and ends on an axis: at $m\pi$ for even $n$ "
        r"and at $m\pi+\frac\pi2$ for odd $n$. Both angles are $n\pi/2$, so $p$ encircles the "
        "origin $n$ times on the full circle, and all roots lie inside."
    )
    page.say(
        "A symmetric matrix $B$ of order $m$ decides whether the roots are real, simple and "
        "crossed in the positive direction. It contains the coefficients of "
        "$(F(x)G(y)-F(y)G(x))/(x-y)$, the highest powers first."
    )
    bezout(page)
    page.say(
        "Suppose that $B$ is positive definite. Then $F$ (or $G$) has no pair of complex roots "
        r"$\xi,\bar\xi$ and no double root, because the quadratic form of $B$ would vanish there. "
        "At each root $F'G>0$ (or $FG'<0$). Conversely, if the roots are real and simple and "
        "$F'G$ (or $FG'$) has this sign at each, the form is a sum of $m$ squares with positive "
        "weights. So all roots of "
        "$p$ lie inside if the $m$ leading minors of $B$ are positive and the roots of $F$ (or "
        "$G$) have $|x|<2$. For even $n$ the first row has the factor $f_m=a_n+a_0$. We divide "
        "by this factor, since the following conditions make it positive."
    )
    page.step(
        "The circle is mapped to the imaginary axis of $s$",
        (z + 1 / z).subs(z, (1 + s) / (1 - s)),
        2 * (1 + s**2) / (1 - s**2),
        name="x",
        because=r"with $z=(1+s)/(1-s)$ the points of the circle are $s=j\tan(\theta/2)$, and "
        "$|x|<2$ means $s^2<0$",
    )
    half_planes(page)
    page.say(
        r"Let $c_k$ be the coefficients of $(1-s)^np$. If all roots lie inside, they have $\Re "
        "s<0$, and all $c_k$ are positive. The $c_k$ whose index has the parity of $n$ are the "
        r"coefficients of $\tfrac12(1-s^2)^mF$ for even $n$, and of $s(1-s^2)^mG$ for odd $n$. If "
        r"they are positive, no root of $F$ (or $G$) has $s^2\ge0$. So the real roots have "
        r"$|x|<2$, and $G(2)>0$. The sum of these $c_k$ is $2^{n-1}(a_n\pm a_0)$. This number is "
        "therefore positive, and no root is at infinity."
    )
    page.say(
        r"So \emph{all roots lie inside if and only if $c_n,c_{n-2},\ldots$, $c_0$ and the $m$ "
        "leading minors are positive}. These are $n+1$ inequalities. Two of the $c_k$ are "
        "$c_0=p(1)$ and $c_n=(-1)^np(-1)$. All $c_k$ are linear in the coefficients of $p$, so "
        "that they are half planes for our loop."
    )
    inners(page)


def halves(page):
    """The two halves of a polynomial, shown for degrees 3 and 4."""
    a_0, a_1, a_2, a_3, a_4 = names = symbols("a_0:5")
    three = (a_3 + a_0) * (x - 1) + a_1 + a_2, (a_3 - a_0) * (x + 1) + a_2 - a_1
    four = (a_4 + a_0) * (x**2 - 2) + (a_3 + a_1) * x + 2 * a_2, (a_4 - a_0) * x + a_3 - a_1
    for n in DEGREES:
        rising = symbols(f"a_0:{n + 1}")
        f, g = (half.subs(x, z + 1 / z) * z ** (n // 2) for half in polynomials(rising))
        f, g = (f * (z + 1), g * (z - 1)) if n % 2 else (f, g * (z - 1 / z))
        page.same("sum", f, sum(c * (z**i + z ** (n - i)) for i, c in enumerate(rising)))
        page.same("difference", g, sum(c * (z**i - z ** (n - i)) for i, c in enumerate(rising)))
    for n, pair in ((3, three), (4, four)):
        found = zip(("sum", "difference"), "FG", polynomials(names[: n + 1]), pair, strict=True)
        for what, name, made, half in found:
            page.step(f"For degree {n} the {what} is a polynomial in $x$", made, half, name=name)


def bezout(page):
    """The matrix of order 2, and its form for orders up to 3."""
    f, g = symbols("f_0:3"), symbols("g_0:2")
    matrix = Matrix([[f[2] * g[1], f[2] * g[0]], [f[2] * g[0], f[1] * g[0] - f[0] * g[1]]])
    page.step(
        "For degree 4 the matrix has two rows and two columns",
        Matrix(jury.bezoutian(f, g)),
        matrix,
        name="B",
        because="the matrix follows from $F=f_2x^2+f_1x+f_0$ and $G=g_1x+g_0$",
    )
    for m in (1, 2, 3):
        f, g = symbols(f"f_0:{m + 1}"), symbols(f"g_0:{m + 1}")
        at = {v: [sum(c * v**i for i, c in enumerate(h)) for h in (f, g)] for v in (x, y)}
        left, right = (Matrix([v**i for i in range(m - 1, -1, -1)]) for v in (x, y))
        form = (left.T * Matrix(jury.bezoutian(f, g)) * right)[0]
        page.same("the form", form * (x - y), at[x][0] * at[y][1] - at[y][0] * at[x][1])
        (F, G), there = at[x], form.subs(y, x)
        page.same("the diagonal", there, F.diff(x) * G - F * G.diff(x))
        if m == 2:
            page.step(
                "At $x=y$ the quadratic form is a Wronskian",
                there,
                F.diff(x) * G - F * G.diff(x),
                name=r"\lim_{y\to x}\frac{F(x)G(y)-F(y)G(x)}{x-y}",
            )


def half_planes(page):
    """The coefficients after the bilinear map, shown for degree 3."""
    for n in (2, 5, 6, 4, 3):
        rising = symbols(f"a_0:{n + 1}")
        mapped = expand(sum(c * (1 + s) ** i * (1 - s) ** (n - i) for i, c in enumerate(rising)))
        kept = [mapped.coeff(s, k) for k in sorted({0, *range(n, -1, -2)})]
        made = jury.half_planes(rising)
        page.same("half planes", made, kept)
        half = polynomials(rising)[n % 2].subs(x, 2 * (1 + s**2) / (1 - s**2))
        part = (mapped + (-1) ** n * mapped.subs(s, -s)) / 2
        page.same("parity", part, (1 - s**2) ** (n // 2) * half * (s if n % 2 else S.Half))
    page.say("For degree 3 the half planes are given by three of the coefficients $c_k$:")
    for k, at, plane, c in zip(
        (0, 1, 3),
        ("first half plane belongs to $z=1$", "second lies between", "last belongs to $z=-1$"),
        made,
        kept,
        strict=True,
    ):
        page.step(f"For degree 3 the {at}", plane, c, name=symbols(f"c_{k}"))


def inners(page):
    """The minors are Jury's inner determinants abs(X - Y) of orders n-1, n-3, ..."""
    for n in (3, 5, 4):
        falling = [S.One, *symbols(f"a_0:{n}")[::-1]]
        minors = jury.criterion(falling).expressions[-(n // 2) :]
        matrices = [jury.inner(falling, order) for order in range(1 + n % 2, n, 2)]
        page.same("Jury's inners", minors, [m.det() for m in matrices])
    page.step(
        "For degree 4 the last minor is one of Jury's determinants",
        minors[-1],
        matrices[-1].det(),
        name="|X-Y|",
        because=f"the determinant is that of $X-Y={latex(matrices[-1])}$; the other minor is the "
        "determinant of its inner matrix, without the first and last row and column. Jury's other "
        "determinants, $|X+Y|$, are not needed",
    )


def polynomials(rising):
    """The polynomials F and G."""
    return [sum(c * x**i for i, c in enumerate(half)) for half in jury.halves(rising)]
