/* The filter over blocks of walls, for several instruction sets: bits are the same in all. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O3", "no-trapping-math", "no-math-errno")
#endif

#include <algorithm>

#include "ordinary.h"

namespace filter {

template <bool fraction>
static inline __attribute__((always_inline)) void devices(Block &b, int n) {
    for (int i = 0; i < n; ++i) {
        const Device x = device<fraction>(b.gamma[i], b.delta[i], b.part[i]);
        b.device[0][i] = x.force.v, b.device[1][i] = x.force.e;
        b.device[2][i] = x.apart.v, b.device[3][i] = x.apart.e;
        b.device[4][i] = x.sums.v, b.device[5][i] = x.sums.e;
        b.device[6][i] = x.gap.v, b.device[7][i] = x.gap.e;
        b.device[8][i] = x.both.v, b.device[9][i] = x.both.e;
        b.device[10][i] = x.loss.v, b.device[11][i] = x.loss.e;
        b.device[12][i] = x.far.v, b.device[13][i] = x.far.e;
    }
}

template <bool fraction, bool both>
static inline __attribute__((always_inline)) void walls(Block &b, int n) {
    for (int i = 0; i < n; ++i) {
        auto &d = b.device;
        const Device x = {{d[0][i], d[1][i]}, {d[2][i], d[3][i]}, {d[4][i], d[5][i]},
                          {d[6][i], d[7][i]}, {d[8][i], d[9][i]}, {d[10][i], d[11][i]},
                          {d[12][i], d[13][i]}};
        b.found[i] = count<fraction, both>(x, b.alpha[i], b.beta[i], b.gamma[i], b.delta[i],
                                           b.steps[i]);
    }
}

CLONES void devices_whole(Block &b, int n) { devices<false>(b, n); }
CLONES void devices_part(Block &b, int n) { devices<true>(b, n); }
CLONES void walls_whole(Block &b, int n) { walls<false, false>(b, n); }
CLONES void walls_part(Block &b, int n) { walls<true, false>(b, n); }
CLONES void twice_whole(Block &b, int n) { walls<false, true>(b, n); }
CLONES void twice_part(Block &b, int n) { walls<true, true>(b, n); }

void counted(Block &b, int n, bool fraction, bool once) {
    if (once) {
        if (fraction) devices_part(b, 1);
        else devices_whole(b, 1);
        for (auto &row : b.device) std::fill(row + 1, row + n, row[0]);
    } else if (fraction) devices_part(b, n);
    else devices_whole(b, n);
    if (fraction) walls_part(b, n);
    else walls_whole(b, n);
    Block some; /* those with two crossings, together */
    int at[BLOCK], left = 0;
    for (int i = 0; i < n; ++i)
        if (b.found[i] == TWICE) at[left++] = i;
    if (left == 0) return;
    for (int k = 0; k < left; ++k) {
        some.alpha[k] = b.alpha[at[k]], some.beta[k] = b.beta[at[k]];
        some.gamma[k] = b.gamma[at[k]], some.delta[k] = b.delta[at[k]];
        some.steps[k] = b.steps[at[k]];
        for (int j = 0; j < NUMBERS; ++j) some.device[j][k] = b.device[j][at[k]];
    }
    if (fraction) twice_part(some, left);
    else twice_whole(some, left);
    for (int k = 0; k < left; ++k) b.found[at[k]] = some.found[k];
}

} // namespace filter
