// Decimals as printed, added, multiplied and divided exactly and rounded once: 0.0003/0.0001 is 3.
"use strict";
globalThis.explorer = {};
(() => {
  function fraction(value) {
    const [, sign, whole, part = "", power = "0"] = /^(-?)(\d*)\.?(\d*)(?:e([+-]?\d+))?$/i.exec(String(Number(value)));
    const ten = 10n ** BigInt(Math.abs(Number(power) - part.length));
    const digits = BigInt(sign + whole + part);
    return Number(power) >= part.length ? [digits * ten, 1n] : [digits, ten];
  }

  // the float64 next to a quotient: 66 bits of it, the last of them set where something is left
  function nearest(above, below) {
    if (above === 0n) return 0;
    const size = (n) => n.toString(2).length;
    const positive = above < 0n ? -above : above;
    const shift = 66 - size(positive) + size(below);
    const scaled = shift > 0 ? positive << BigInt(shift) : positive;
    const divisor = shift > 0 ? below : below << BigInt(-shift);
    const bits = (scaled / divisor) | (scaled % divisor ? 1n : 0n);
    return (above < 0n ? -1 : 1) * Number(bits) * 2 ** -shift;
  }

  // the product of the first divided by that of the second
  explorer.quotient = (factors, divisors) => {
    let [above, below] = [1n, 1n];
    for (const value of factors) {
      const [n, d] = fraction(value);
      above *= n;
      below *= d;
    }
    for (const value of divisors) {
      const [n, d] = fraction(value);
      above *= d;
      below *= n;
    }
    return below === 0n ? NaN : nearest(above, below);
  };

  // the sum of two decimals, as text
  explorer.sum = (one, other) => {
    const [[a, b], [c, d]] = [fraction(one), fraction(other)];
    return String(nearest(a * d + c * b, b * d));
  };

  explorer.difference = (one, other) => explorer.sum(one, String(-Number(other)));
})();
