/* Written by `symhaptic kernels` from the stable forms; do not edit. */
#define SINGLE
#include "haptic.c"
