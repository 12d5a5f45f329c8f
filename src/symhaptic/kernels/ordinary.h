/* Functions of blocks of arguments and results, each a row; NaN first where the kernel is needed. */
#ifndef ORDINARY_H
#define ORDINARY_H

#include "filter.h"

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__) && \
    !defined(ONE_SET)
#define CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define CLONES
#endif

namespace ordinary {

using Rows = double[5][filter::BLOCK];

void discretize(int n, const Rows &x, Rows &y);
void stability_boundary(int n, const Rows &x, Rows &y);
void passivity_margin_at(int n, const Rows &x, Rows &y);

} // namespace ordinary
#endif
