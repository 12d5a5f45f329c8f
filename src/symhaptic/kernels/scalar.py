# Written by `symhaptic kernels` from the stable forms; do not edit.
"""How large is it, of one?  The stable forms as functions of floats, without NumPy."""

from functools import lru_cache
from math import atan2, cos, exp, expm1, floor, inf, nan, sin, sqrt, tan

# 1/n!
inverse_factorial = (1.0, 1.0, 0.5, 0.16666666666666666, 0.041666666666666664, \
    0.008333333333333333, 0.001388888888888889, 0.0001984126984126984, 2.48015873015873e-05, \
    2.7557319223985893e-06, 2.755731922398589e-07, 2.505210838544172e-08, 2.08767569878681e-09, \
    1.6059043836821613e-10, 1.1470745597729725e-11, 7.647163731819816e-13, 4.779477332387385e-14, \
    2.8114572543455206e-15, 1.5619206968586225e-16, 8.22063524662433e-18, 4.110317623312165e-19, \
    1.9572941063391263e-20, 8.896791392450574e-22, 3.868170170630684e-23, 1.6117375710961184e-24, \
    6.446950284384474e-26, 2.4795962632247976e-27, 9.183689863795546e-29, 3.279889237069838e-30,)

def decay_series(x):
  square = x*x
  one = 0.0
  two = 0.0
  for number in inverse_factorial[slice(19, 4 - 1, -1)]:
    both = number + square*two
    two = one
    one = both
  DecaySeries_out = square*two - one*x + 0.16666666666666666
  return DecaySeries_out

def fast_two_sum(x, y):
  total = x + y
  back = total - x
  total_out = total
  total_low_out = y - back
  return total_out, total_low_out

def one_minus(x, x_low):
  total, total_low = fast_two_sum(1.0, -x)
  total_out = total
  total_low_out = total_low - x_low
  return total_out, total_low_out

def two_prod_error(y, z):
  product = y*z
  big = 134217729.0*y
  away = big - y
  high = big - away
  low = y - high
  big2 = 134217729.0*z
  away2 = big2 - z
  high2 = big2 - away2
  low2 = z - high2
  left = high*high2
  left2 = left - product
  left3 = high*low2 + left2
  left4 = high2*low + left3
  TwoProdError_out = left4 + low*low2
  return TwoProdError_out

def wide_prod(x, y, y_low):
  total_out = x*y
  total_low_out = x*y_low + two_prod_error(x, y)
  return total_out, total_low_out

def pair_prod(x, x_low, y, y_low):
  prod, prod_low = wide_prod(x, y, y_low)
  total_out = prod
  total_low_out = prod_low + x_low*y
  return total_out, total_low_out

def brief_fading(rate, rate_low):
  total, total_low = fast_two_sum(1.0, -0.5*rate)
  total2, total_low2 = fast_two_sum(total, (rate*rate)*decay_series(rate))
  bent = rate_low*(0.125*(rate*rate) - 0.3333333333333333*rate + 0.5)
  mean_low = total_low - bent + total_low2
  prod, prod_low = pair_prod(rate, rate_low, total2, mean_low)
  less, less_low = one_minus(prod, prod_low)
  fall_out = less
  fall_low_out = less_low
  mean_out = total2
  mean_low_out = mean_low
  return fall_out, fall_low_out, mean_out, mean_low_out

def pair_quot(x, x_low, y, y_low):
  total = x/y
  left = x - total*y
  left2 = left - two_prod_error(total, y)
  rest = x_low - total*y_low
  left3 = left2 + rest
  total_out = total
  total_low_out = left3/y
  return total_out, total_low_out

def fading_pair(rate, rate_low):
  if rate < 0.75:
    fall, fall_low, mean, mean_low = brief_fading(rate, rate_low)
    fall_out = fall
    fall_low_out = fall_low
    mean_out = mean
    mean_low_out = mean_low
  else:
    sunk = exp(-rate)
    sunk_low = -rate_low*sunk
    less, less_low = one_minus(sunk, sunk_low)
    quot, quot_low = pair_quot(less, less_low, rate, rate_low)
    fall_out = sunk
    fall_low_out = sunk_low
    mean_out = quot
    mean_low_out = quot_low
  return fall_out, fall_low_out, mean_out, mean_low_out

def root_miss(square, square_low, root):
  sign_low = -square_low if square < 0.0 else square_low
  left = abs(square) - (root*root)
  left2 = left - two_prod_error(root, root)
  left3 = left2 + sign_low
  whole = 1.0 if root == 0.0 else root
  RootMiss_out = 0.5*left3/whole
  return RootMiss_out

def real_poles(gamma, half, w, w_low, root):
  total, total_low = fast_two_sum(half, root)
  p_low = total_low + root_miss(w, w_low, root)
  whole = 1.0 if total == 0.0 else total
  quot, quot_low = pair_quot(gamma, 0.0, whole, p_low)
  p_out = whole
  p_low_out = p_low
  q_out = quot
  q_low_out = quot_low
  return p_out, p_low_out, q_out, q_low_out

def creeping_device(gamma, half, w, w_low, root):
  p, p_low, q, q_low = real_poles(gamma, half, w, w_low, root)
  fall, fall_low, mean, mean_low = fading_pair(q, q_low)
  root_low = root_miss(w, w_low, root)
  fall2, fall_low2, mean2, mean_low2 = fading_pair(2.0*root, 2.0*root_low)
  p_out = p
  p_low_out = p_low
  slow_out = fall
  slow_low_out = fall_low
  mean_out = mean
  mean_low_out = mean_low
  ratio_out = fall2
  ratio_low_out = fall_low2
  far_out = mean2
  far_low_out = mean_low2
  return p_out, p_low_out, slow_out, slow_low_out, mean_out, mean_low_out, ratio_out, \
      ratio_low_out, far_out, far_low_out

def two_diff(x, y):
  total = x - y
  back = total - x
  rest = total - back
  one = x - rest
  two = -back - y
  total_out = total
  total_low_out = one + two
  return total_out, total_low_out

def two_prod(x, y):
  total_out = x*y
  total_low_out = two_prod_error(x, y)
  return total_out, total_low_out

@lru_cache(256)
def device_motion(gamma, delta):
  half = 0.5*delta
  prod, prod_low = two_prod(half, half)
  diff, diff_low = two_diff(prod, gamma)
  total, total_low = fast_two_sum(diff, diff_low + prod_low)
  root = sqrt(abs(total))
  half_out = half
  w_out = total
  w_low_out = total_low
  root_out = root
  reach_out = 0.25*gamma if total < 0.0 else 0.4444444444444444*half + 0.4444444444444444*root
  return half_out, w_out, w_low_out, root_out, reach_out

def one_plus(x, x_low):
  total, total_low = fast_two_sum(1.0, x)
  total_out = total
  total_low_out = total_low + x_low
  return total_out, total_low_out

def pair_diff(x, x_low, y, y_low):
  diff, diff_low = two_diff(x, y)
  lost = diff_low + x_low
  total_out = diff
  total_low_out = lost - y_low
  return total_out, total_low_out

def pair_square(x, x_low):
  prod, prod_low = wide_prod(x, x, 2.0*x_low)
  total_out = prod
  total_low_out = prod_low
  return total_out, total_low_out

def plant_n0_term(gamma, delta, one, one_low, two, two_low, number):
  prod, prod_low = wide_prod(delta, one, one_low)
  prod2, prod_low2 = wide_prod(gamma, two, two_low)
  diff, diff_low = pair_diff(prod, prod_low, prod2, prod_low2)
  diff2, diff_low2 = pair_diff(diff, diff_low, -number, 0.0)
  total_out = diff2
  total_low_out = diff_low2
  return total_out, total_low_out

def rounded(x, x_low):
  Rounded_out = x + x_low
  return Rounded_out

@lru_cache(256)
def plant_n0_series(gamma, delta):
  one = 0.0
  two = 0.0
  for number in inverse_factorial[slice((13 if 0.5* \
      delta < 0.0625 and abs(gamma) < 0.00390625 else 28), 6 - 1, -1)]:
    next_one = delta*one - gamma*two + number
    two = one
    one = next_one
  one2, one_low = plant_n0_term(gamma, delta, one, 0.0, two, 0.0, 0.008333333333333333)
  one3, one_low2 = plant_n0_term(gamma, delta, one2, one_low, one, 0.0, 0.041666666666666664)
  one4, one_low3 = plant_n0_term(gamma, delta, one3, one_low2, one2, one_low, 0.16666666666666666)
  one5, one_low4 = plant_n0_term(gamma, delta, one4, one_low3, one3, one_low2, 0.0)
  PlantN0Series_out = rounded(one5, one_low4)
  return PlantN0Series_out

def scaled_sum(fall, fall_low, y, z):
  diff, diff_low = two_diff(y, -z)
  prod, prod_low = pair_prod(fall, fall_low, diff, diff_low)
  ScaledSum_out = rounded(prod, prod_low)
  return ScaledSum_out

def plant_n0_near(decayed, decayed_low, gamma, delta):
  squared, squared_low = pair_square(decayed, decayed_low)
  PlantN0Near_out = scaled_sum(squared, squared_low, plant_n0_series(gamma, delta), 0.5)
  return PlantN0Near_out

def plant_n0_creep(reach, p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far, \
    far_low, decayed, decayed_low, gamma, delta):
  if reach < 0.5625:
    PlantN0Creep_out = plant_n0_near(decayed, decayed_low, gamma, delta)
  else:
    prod, prod_low = pair_prod(ratio, ratio_low, mean, mean_low)
    diff, diff_low = pair_diff(far, far_low, prod, prod_low)
    quot, quot_low = pair_quot(diff, diff_low, p, p_low)
    prod2, prod_low2 = pair_prod(slow, slow_low, quot, quot_low)
    PlantN0Creep_out = rounded(prod2, prod_low2)
  return PlantN0Creep_out

def pair_sum(x, x_low, y, y_low):
  diff, diff_low = two_diff(x, -y)
  lost = diff_low + x_low
  total_out = diff
  total_low_out = lost + y_low
  return total_out, total_low_out

def plant_n0_swing(reach, half, envelope, even, even_low, wave, wave_low, near, sunk, decayed, \
    decayed_low, gamma):
  if reach < 0.5625:
    PlantN0Swing_out = plant_n0_near(decayed, decayed_low, gamma, 2.0*half)
  else:
    if near > 0.0:
      PlantN0Swing_out = sunk
    else:
      prod, prod_low = wide_prod(half, wave, wave_low)
      diff, diff_low = pair_diff(prod, prod_low, even, even_low)
      total, total_low = pair_sum(diff, diff_low, envelope, 0.0)
      prod2, prod_low2 = wide_prod(envelope, total, total_low)
      quot, quot_low = pair_quot(prod2, prod_low2, gamma, 0.0)
      PlantN0Swing_out = rounded(quot, quot_low)
  return PlantN0Swing_out

def plant_n1_series(h, w):
  total = 0.0
  one = 0.0
  two = 0.0
  for number in inverse_factorial[slice((13 if abs(w) < 0.00390625 and h < 0.0625 else 28), 3 - \
      1, -1)]:
    even = number + two*w
    next_total = even + h*total
    two = one
    one = even
    total = next_total
  PlantN1Series_out = h*total + two*w
  return PlantN1Series_out

def plant_n1_creep(reach, half, w, p, p_low, slow, slow_low, mean, mean_low, far, far_low, \
    decayed, decayed_low):
  if reach < 0.5625:
    PlantN1Creep_out = scaled_sum(decayed, decayed_low, plant_n1_series(half, w), 0.5)
  else:
    prod, prod_low = pair_prod(slow, slow_low, far, far_low)
    diff, diff_low = pair_diff(mean, mean_low, prod, prod_low)
    quot, quot_low = pair_quot(diff, diff_low, p, p_low)
    PlantN1Creep_out = rounded(quot, quot_low)
  return PlantN1Creep_out

def plant_n1_swing(reach, half, w, envelope, even, even_low, wave, wave_low, near, risen, \
    decayed, decayed_low, gamma):
  if reach < 0.5625:
    PlantN1Swing_out = scaled_sum(decayed, decayed_low, plant_n1_series(half, w), 0.5)
  else:
    if near > 0.0:
      PlantN1Swing_out = risen
    else:
      prod, prod_low = wide_prod(half, wave, wave_low)
      total, total_low = pair_sum(even, even_low, prod, prod_low)
      prod2, prod_low2 = wide_prod(envelope, total, total_low)
      less, less_low = one_minus(prod2, prod_low2)
      quot, quot_low = pair_quot(less, less_low, gamma, 0.0)
      PlantN1Swing_out = rounded(quot, quot_low)
  return PlantN1Swing_out

def slow_fade(reach, half):
  if reach < 0.5625:
    fall, fall_low, mean, mean_low = brief_fading(0.5*half, 0.0)
    squared, squared_low = pair_square(fall, fall_low)
    decayed_out = squared
    decayed_low_out = squared_low
  else:
    decayed_out = 0.0
    decayed_low_out = 0.0
  return decayed_out, decayed_low_out

def cos_series(w):
  square = w*w
  one = 0.0
  two = 0.0
  for number in inverse_factorial[slice(22, 6 - 1, -2)]:
    both = number + square*two
    two = one
    one = both
  CosSeries_out = one*w + square*two + 0.041666666666666664
  return CosSeries_out

def sin_series(w):
  square = w*w
  one = 0.0
  two = 0.0
  for number in inverse_factorial[slice(21, 5 - 1, -2)]:
    both = number + square*two
    two = one
    one = both
  SinSeries_out = one*w + square*two + 0.16666666666666666
  return SinSeries_out

def waving_pair(square, square_low, angle):
  if square > -1.5:
    total, total_low = fast_two_sum(1.0, 0.5*square)
    total2, total_low2 = fast_two_sum(total, (square*square)*cos_series(square))
    both = total_low + total_low2
    total3, total_low3 = one_plus(square*sin_series(square), 0.16666666666666666*square_low)
    even_out = total2
    even_low_out = both + 0.5*square_low
    odd_out = total3
    odd_low_out = total_low3
  else:
    angle_low = root_miss(square, square_low, angle)
    sine = sin(angle)
    cosine = cos(angle)
    quot, quot_low = pair_quot(sine, angle_low*cosine, angle, angle_low)
    even_out = cosine
    even_low_out = -angle_low*sine
    odd_out = quot
    odd_low_out = quot_low
  return even_out, even_low_out, odd_out, odd_low_out

def whole_turns(half, square, square_low, root, stiff):
  if half < 0.75 and root > 3.0 and root < 67108864.0:
    count = floor(0.5*root/3.141592653589793 + 0.5)
    prod3, prod_low3 = two_prod(count, 6.283185307179586)
    diff6, diff_low6 = two_diff(root, -prod3)
    missed = root_miss(square, square_low, root)
    turns = count*count
    prod, prod_low = two_prod(turns, 39.47841760435743)
    prod2, prod_low2 = two_prod(turns, 2.5061182034958845e-15)
    diff, diff_low = two_diff(-square, prod)
    diff2, diff_low2 = two_diff(diff, prod_low)
    diff3, diff_low3 = two_diff(diff2, prod2)
    diff4, diff_low4 = two_diff(diff3, square_low)
    turned_low = 1.4920070805839235e-31*turns
    low = diff_low + diff_low2 + diff_low3 + diff_low4 - prod_low2 - turned_low
    diff5, diff_low5 = two_diff(diff4, -low)
    back = 2.4492935982947064e-16*count
    quot, quot_low = pair_quot(diff5, diff_low5, diff6, back + diff_low6 + missed + prod_low3)
    far = quot*quot
    if count > 0.0 and far < 1.5:
      fall, fall_low, mean, mean_low = brief_fading(half, 0.0)
      less2, less_low2 = one_minus(fall, fall_low)
      total3, total_low3 = fast_two_sum(less2, less_low2)
      squared2, squared_low2 = pair_square(total3, total_low3)
      squared, squared_low = pair_square(quot, quot_low)
      less, less_low = one_minus(squared*sin_series(-squared), 0.0)
      prod4, prod_low4 = wide_prod(quot, less, less_low)
      bent = (squared*squared)*cos_series(-squared)
      total, total_low = fast_two_sum(0.5*squared, -bent)
      lift_low = 0.5*less*squared_low + total_low
      prod5, prod_low5 = pair_prod(fall, fall_low, total, lift_low)
      total4, total_low4 = pair_sum(squared2, squared_low2, 2.0*prod5, 2.0*prod_low5)
      quot2, quot_low2 = pair_quot(prod4, prod_low4 + quot_low*(1.0 - total), root, missed)
      prod6, prod_low6 = pair_prod(fall, fall_low, quot2, quot_low2)
      diff7, diff_low7 = pair_diff(mean, mean_low, prod6, prod_low6)
      prod7, prod_low7 = wide_prod(half, diff7, diff_low7)
      total2, total_low2 = pair_sum(prod7, prod_low7, prod5, prod_low5)
      diff8, diff_low8 = pair_diff(mean, mean_low, quot2, quot_low2)
      prod8, prod_low8 = wide_prod(half, diff8, diff_low8)
      diff9, diff_low9 = pair_diff(total, lift_low, prod8, prod_low8)
      diff10, diff_low10 = two_diff(diff9, -diff_low9)
      prod9, prod_low9 = pair_prod(fall, fall_low, diff10, diff_low10)
      quot3, quot_low3 = pair_quot(total2, total_low2, stiff, 0.0)
      quot4, quot_low4 = pair_quot(prod9, prod_low9, stiff, 0.0)
      quot5, quot_low5 = pair_quot(total4, total_low4, stiff, 0.0)
      near_out = 1.0
      risen_out = rounded(quot3, quot_low3)
      sunk_out = rounded(quot4, quot_low4)
      moved_out = rounded(quot5, quot_low5)
    else:
      near_out = 0.0
      risen_out = 0.0
      sunk_out = 0.0
      moved_out = 0.0
  else:
    near_out = 0.0
    risen_out = 0.0
    sunk_out = 0.0
    moved_out = 0.0
  return near_out, risen_out, sunk_out, moved_out

def swinging_device(gamma, half, w, w_low, root):
  even, even_low, odd, odd_low = waving_pair(w, w_low, root)
  near, risen, sunk, moved = whole_turns(half, w, w_low, root, gamma)
  envelope_out = exp(-half)
  even_out = even
  even_low_out = even_low
  wave_out = odd
  wave_low_out = odd_low
  near_out = near
  risen_out = risen
  sunk_out = sunk
  moved_out = moved
  return envelope_out, even_out, even_low_out, wave_out, wave_low_out, near_out, risen_out, \
      sunk_out, moved_out

@lru_cache(256)
def device_n0_n1_trace(gamma, delta):
  half, w, w_low, root, reach = device_motion(gamma, delta)
  decayed, decayed_low = slow_fade(reach, half)
  if w < 0.0:
    envelope, even, even_low, wave, wave_low, near, risen, sunk, moved = \
        swinging_device(gamma, half, w, w_low, root)
    prod, prod_low = wide_prod(envelope, even, even_low)
    rounded_of = rounded(prod, prod_low)
    n0_out = plant_n0_swing(reach, half, envelope, even, even_low, wave, wave_low, near, sunk, \
        decayed, decayed_low, gamma)
    n1_out = plant_n1_swing(reach, half, w, envelope, even, even_low, wave, wave_low, near, \
        risen, decayed, decayed_low, gamma)
    trace_out = 2.0*rounded_of
  else:
    p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far, far_low = \
        creeping_device(gamma, half, w, w_low, root)
    total, total_low = one_plus(ratio, ratio_low)
    prod2, prod_low2 = pair_prod(slow, slow_low, total, total_low)
    n0_out = plant_n0_creep(reach, p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, \
        far, far_low, decayed, decayed_low, gamma, delta)
    n1_out = plant_n1_creep(reach, half, w, p, p_low, slow, slow_low, mean, mean_low, far, \
        far_low, decayed, decayed_low)
    trace_out = rounded(prod2, prod_low2)
  return n0_out, n1_out, trace_out

def decay(x):
  if x == 0.0:
    Decay_out = 1.0
  else:
    Decay_out = -expm1(-x)/x
  return Decay_out

def denominator_at_minus_one_creep(slow, slow_low, ratio, ratio_low):
  prod, prod_low = pair_prod(slow, slow_low, ratio, ratio_low)
  total, total_low = one_plus(slow, slow_low)
  total2, total_low2 = one_plus(prod, prod_low)
  prod2, prod_low2 = pair_prod(total, total_low, total2, total_low2)
  DenominatorAtMinusOneCreep_out = rounded(prod2, prod_low2)
  return DenominatorAtMinusOneCreep_out

def half_squares(half, envelope, wave, back):
  diff, diff_low = two_diff(wave, back)
  squared, squared_low = pair_square(diff, diff_low)
  prod, prod_low = wide_prod(envelope, squared, squared_low)
  grown = -0.5*expm1(-half)
  total, total_low = pair_sum(prod, prod_low, grown*grown, 0.0)
  total_out = total
  total_low_out = total_low
  return total_out, total_low_out

def denominator_at_minus_one_swing(half, w, w_low, root, envelope, even, even_low):
  prod, prod_low = wide_prod(2.0*envelope, even, even_low)
  if prod > 0.0:
    total2, total_low2 = one_plus(exp(-2.0*half), 0.0)
    total3, total_low3 = pair_sum(total2, total_low2, prod, prod_low)
    DenominatorAtMinusOneSwing_out = rounded(total3, total_low3)
  else:
    angle = 0.5*root
    total, total_low = half_squares(half, envelope, cos(angle), 0.5*root_miss(w, w_low, root)* \
        sin(angle))
    DenominatorAtMinusOneSwing_out = 4.0*rounded(total, total_low)
  return DenominatorAtMinusOneSwing_out

def numerator_at_one_series(h, w):
  y = h*h
  total = 0.0
  inner = 0.0
  for number in inverse_factorial[slice((12 if abs(w) < 0.00390625 and h < 0.0625 else 28), 4 - \
      1, -2)]:
    own = inner*w + number
    next_total = own + total*y
    inner = own
    total = next_total
  NumeratorAtOneSeries_out = inner*w + total*y
  return NumeratorAtOneSeries_out

def numerator_at_one_creep(reach, half, w, p, p_low, slow, slow_low, mean, mean_low, ratio, \
    ratio_low):
  if reach < 1.0:
    NumeratorAtOneCreep_out = 2.0*scaled_sum(exp(-half), 0.0, numerator_at_one_series(half, w), 0.5)
  else:
    prod, prod_low = pair_prod(slow, slow_low, ratio, ratio_low)
    less, less_low = one_minus(prod, prod_low)
    prod2, prod_low2 = pair_prod(mean, mean_low, less, less_low)
    quot, quot_low = pair_quot(prod2, prod_low2, p, p_low)
    NumeratorAtOneCreep_out = rounded(quot, quot_low)
  return NumeratorAtOneCreep_out

def numerator_at_one_swing(reach, half, w, w_low, root, envelope, near, moved, gamma):
  if reach < 1.0:
    NumeratorAtOneSwing_out = 2.0*scaled_sum(envelope, 0.0, numerator_at_one_series(half, w), 0.5)
  else:
    if near > 0.0:
      NumeratorAtOneSwing_out = moved
    else:
      angle = 0.5*root
      back = -0.5*root_miss(w, w_low, root)*cos(angle)
      total, total_low = half_squares(half, envelope, sin(angle), back)
      quot, quot_low = pair_quot(total, total_low, gamma, 0.0)
      NumeratorAtOneSwing_out = 4.0*rounded(quot, quot_low)
  return NumeratorAtOneSwing_out

def numerator_gap_series(h, w):
  y = h*h
  total = 0.0
  inner = 0.0
  for number in inverse_factorial[slice((13 if abs(w) < 0.00390625 and h < 0.0625 else 27), 5 - \
      1, -2)]:
    own = inner*w + number
    next_total = own + total*y
    inner = own
    total = next_total
  NumeratorGapSeries_out = inner*w + total*y + 9.25185853854297e-18
  return NumeratorGapSeries_out

def numerator_gap_creep(reach, half, w, p, slow, mean, mean_low, ratio, far, far_low, delta):
  if reach < 1.0:
    NumeratorGapCreep_out = scaled_sum(exp(-half), 0.0, numerator_gap_series(half, w), \
        0.16666666666666666)
  else:
    prod, prod_low = wide_prod(2.0*slow, far, far_low)
    diff, diff_low = pair_diff(mean, mean_low, prod, prod_low)
    prod2, prod_low2 = wide_prod(ratio*slow, mean, mean_low)
    top = diff + prod2
    low = diff_low + prod_low2
    whole = delta*p
    NumeratorGapCreep_out = (low + top)/whole
  return NumeratorGapCreep_out

def numerator_gap_swing(reach, half, w, envelope, wave, wave_low, gamma, delta):
  if reach < 1.0:
    NumeratorGapSwing_out = scaled_sum(envelope, 0.0, numerator_gap_series(half, w), \
        0.16666666666666666)
  else:
    prod, prod_low = wide_prod(envelope, wave, wave_low)
    diff, diff_low = pair_diff(decay(delta), 0.0, prod, prod_low)
    quot, quot_low = pair_quot(diff, diff_low, gamma, 0.0)
    NumeratorGapSwing_out = rounded(quot, quot_low)
  return NumeratorGapSwing_out

@lru_cache(256)
def device_at_minus_one_kick_together_n_gap_n0_n1(gamma, delta):
  half, w, w_low, root, reach = device_motion(gamma, delta)
  if w < 0.0:
    envelope, even, even_low, wave, wave_low, near, risen, sunk, moved = \
        swinging_device(gamma, half, w, w_low, root)
    prod, prod_low = wide_prod(envelope, wave, wave_low)
    decayed, decayed_low = slow_fade(reach, half)
    at_minus_one_out = denominator_at_minus_one_swing(half, w, w_low, root, envelope, even, \
        even_low)
    kick__out = rounded(prod, prod_low)
    together_out = numerator_at_one_swing(reach, half, w, w_low, root, envelope, near, moved, gamma)
    n_gap_out = numerator_gap_swing(reach, half, w, envelope, wave, wave_low, gamma, delta)
    n0_out = plant_n0_swing(reach, half, envelope, even, even_low, wave, wave_low, near, sunk, \
        decayed, decayed_low, gamma)
    n1_out = plant_n1_swing(reach, half, w, envelope, even, even_low, wave, wave_low, near, \
        risen, decayed, decayed_low, gamma)
  else:
    p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far, far_low = \
        creeping_device(gamma, half, w, w_low, root)
    prod2, prod_low2 = pair_prod(slow, slow_low, far, far_low)
    decayed, decayed_low = slow_fade(reach, half)
    at_minus_one_out = denominator_at_minus_one_creep(slow, slow_low, ratio, ratio_low)
    kick__out = rounded(prod2, prod_low2)
    together_out = numerator_at_one_creep(reach, half, w, p, p_low, slow, slow_low, mean, \
        mean_low, ratio, ratio_low)
    n_gap_out = numerator_gap_creep(reach, half, w, p, slow, mean, mean_low, ratio, far, far_low, \
        delta)
    n0_out = plant_n0_creep(reach, p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, \
        far, far_low, decayed, decayed_low, gamma, delta)
    n1_out = plant_n1_creep(reach, half, w, p, p_low, slow, slow_low, mean, mean_low, far, \
        far_low, decayed, decayed_low)
  return at_minus_one_out, kick__out, together_out, n_gap_out, n0_out, n1_out

def cubic_root(k0, k1, k2, k3, low, high, rise):
  three = 3.0*k3
  two = 2.0*k2
  convex = 1.0 if three*(high + low) + two > 0.0 else -1.0
  down = 1.0 if convex*rise > 0.0 else -1.0
  begin = 0.0 if convex*k0 > 0.0 and high > 0.0 and low < 0.0 else (high if down > 0.0 else low)
  end = 0.0 if convex*k0 <= 0.0 and high > 0.0 and low < 0.0 else (low if down > 0.0 else high)
  part = 0.0625*begin
  above = 1.0 if abs(end) < abs(part) and convex* \
      (k0 + part*(k1 + part*(k2 + k3*part))) > 0.0 else 0.0
  begin2 = part if above > 0.0 else begin
  end2 = part if above <= 0.0 and abs(end) < abs(part) else end
  for count_begin2 in range(8):
    if abs(begin2) <= 16.0*max(1.499696813895631e-241, abs(end2)):
      break
    more = max(1.499696813895631e-241, abs(end2))
    size = sqrt(more)*sqrt(abs(begin2))
    at = -size if begin2 < 0.0 else size
    outside = 1.0 if convex*(at*(at*(at*k3 + k2) + k1) + k0) > 0.0 else 0.0
    next_begin = at if outside > 0.0 else begin2
    next_end = end2 if outside > 0.0 else at
    end2 = next_end
    begin2 = next_begin
  y = begin2
  moves = 1.0
  for count_y in range(98):
    if moves == 0.0:
      break
    steep = k1 + y*(three*y + two)
    some = 1.0 if steep == 0.0 else steep
    move = 0.0 if steep == 0.0 else (k0 + y*(k1 + y*(k2 + k3*y)))/some
    new = min(high, y - move)
    new2 = max(low, new)
    moves2 = 1.0 if down*(y - new2) > 0.0 else 0.0
    next_y = new2 if moves2 > 0.0 else y
    moves = moves2
    y = next_y
  CubicRoot_out = y
  return CubicRoot_out

def crossing_part(x, u, x_off, u_off, steep, low, high):
  most = max(abs(u), abs(x))
  least = min(abs(u), abs(x))
  whole = 1.0 if most == 0.0 else most
  ratio = least/whole
  longer = sqrt(ratio*ratio + 1.0)
  size = longer*most
  whole2 = 1.0 if size == 0.0 else size
  per = 1.0/whole2
  real = per*x
  up = per*u
  along = per*x_off
  across = per*u_off
  away = across + along
  one = abs(real)
  two = abs(up)
  blur = (2.0*away + 1.0)*(across*one + along*two)
  rest = atan2(-u if x < 0.0 else u, abs(x))
  falls = per*steep
  tilt = 0.5*low - 0.5*high
  square = up*up
  fast = square*(high + low) + 2.0*abs(falls)
  halves_out = (-1.0 if u < 0.0 else 1.0) if x < 0.0 else 0.0
  rest_out = rest
  size_out = size
  per_out = per
  off_out = across*two + along*one + away*away if size > 0.0 else 1.0
  blur_out = blur + 4.440892098500626e-16*abs(rest) if away < 0.25 else 4.0
  slope_out = 2.0*falls*real + 2.0*square*tilt
  fast_out = fast
  bend__out = 2.0*(falls*falls) + fast*fast + 2.0*high*low*square
  turn__out = up*(real*tilt - falls)
  spread__out = two*(one*abs(tilt) + abs(falls))
  return halves_out, rest_out, size_out, per_out, off_out, blur_out, slope_out, fast_out, \
      bend__out, turn__out, spread__out

def phase_turns(y, rest, off, loose, free, alpha, slope, far, d, n1, loss, together, apart, \
    apart_off, n1_off, a_off):
  at = max(0.0, y)
  still = max(0.0, rest)
  sine = 2.0*sqrt(at*still)
  total = 2.0 - loss
  plain = loose + 4.440892098500626e-16
  made = loose + 1.3322676295501878e-15
  edge = min(at, still)
  whole = 1.0 if at == 0.0 else at
  low = edge/whole
  whole2 = 1.0 if still == 0.0 else still
  high = edge/whole2
  halves2, turned2, size2, per2, away2, blur2, rise2, fast2, bend2, turn2, spread2 = \
      crossing_part(still*together - apart*at, n1*sine, apart_off*at + made* \
      (at*abs(apart) + still*together), sine*(made*abs(n1) + n1_off), edge*(-apart - together), \
      low, high)
  halves3, turned3, size3, per3, away3, blur3, rise3, fast3, bend3, turn3, spread3 = \
      crossing_part(alpha*still - at*far, sine*slope, plain*(at*abs(far) + still*abs(alpha)), \
      plain*sine*abs(slope), edge*(-alpha - far), low, high)
  halves, turned, size, per, away, blur, rise, fast, bend_, turn_, spread_ = \
      crossing_part(-2.0*off*total, loss*sine, 4.0*a_off + total* \
      (2.0*free + 8.881784197001252e-16*abs(off)), loss*made*sine, -2.0*edge*total, low, high)
  ratio = per*size2
  gap_ = 1.0 - 0.25*ratio*size3
  rough = away + away2 + away3 + 1.3322676295501878e-15
  distant = abs(gap_)
  miss = 3.0*away + 8.881784197001252e-16
  miss2 = 3.0*away2 + 8.881784197001252e-16
  miss3 = 3.0*away3 + 8.881784197001252e-16
  sure = -fast*miss - fast2*miss2 - fast3*miss3 + abs(rise2 - rise + rise3)
  whole3 = 1.0 if sure == 0.0 else sure
  reach = 0.25*(9.0*distant + 9.0*rough)/whole3
  bends = bend_ + bend2 + bend3
  half = atan2(sqrt(still) if at > 2.0 else sqrt(at), sqrt(at) if at > 2.0 else sqrt(still))
  late = d + 2.0
  halves4 = halves2 - halves + halves3 - (late if at > 2.0 else 0.0)
  around = late*(-2.0*half if at > 2.0 else 2.0*half)
  share = 0.5*(-around - turned + turned2 + turned3)/3.141592653589793
  even = floor(0.5*halves4)
  left = 0.5*halves4 - even
  near = abs(share - floor(share + 0.5))
  distance = near if left == 0.5 else 0.5 - near
  whole4 = 1.0 if sine == 0.0 else sine
  delayed = 2.0*edge*late/whole4
  most = delayed + spread_ + spread2 + spread3
  blur_ = blur + blur2 + blur3 + half*late*(loose + 8.881784197001252e-16) + reach* \
      (8.881784197001252e-16*delayed + miss*spread_ + miss2*spread2 + miss3*spread3 + 2.0*most* \
      reach*(fast + fast2 + fast3 + 2.0) + abs(delayed + turn_ - turn2 - turn3))
  good = 1.0 if blur_ < 6.0*distance and reach < 0.25 and sure > 0.0 and sure > 8.0*bends* \
      reach else 0.0
  if good > 0.0:
    PhaseTurns_out = even + (floor(share) + 1.0 if left == 0.5 else floor(left + share + 0.5))
  else:
    PhaseTurns_out = nan
  return PhaseTurns_out

def piece_turns(k0, k1, k2, k3, low, high, at_low, at_high, zone, alpha, slope, far, d, n1, loss, \
    together, apart, apart_off, n1_off, a_off, center, beyond):
  if ((at_high >= 0.0 and at_low < 0.0) or (at_high < 0.0 and at_low >= 0.0)) and ( \
      at_low != 0.0 or low != 0.0) and high > low:
    x = cubic_root(k0, k1, k2, k3, low, high, at_high - at_low)
    y = x if zone == 0.0 else (center + x if zone == 1.0 else 4.0 - x)
    rest = 4.0 - x if zone == 0.0 else (beyond - x if zone == 1.0 else x)
    if rest > 0.0 and y > 0.0:
      off = x - center if zone == 0.0 else (x if zone == 1.0 else beyond - x)
      loose = 1.7763568394002505e-15 if zone == 1.0 else 2.220446049250313e-16
      free = 0.0 if zone == 1.0 else 8.881784197001252e-16*(center if zone == 0.0 else beyond)
      found = phase_turns(y, rest, off, loose, free, alpha, slope, far, d, n1, loss, together, \
          apart, apart_off, n1_off, a_off)
      up = 1.0 if at_high > at_low else -1.0
      rises = -up if zone == 2.0 else up
      PieceTurns_out = -2.0*found*rises
    else:
      PieceTurns_out = nan
  else:
    PieceTurns_out = 0.0
  return PieceTurns_out

def touches(leads, y, rest, off, loose, free, alpha, slope, far, n1, loss, together, apart, \
    apart_off, n1_off, a_off):
  at = max(0.0, y)
  still = max(0.0, rest)
  sine = 2.0*sqrt(at*still)
  total = 2.0 - loss
  plain = loose + 4.440892098500626e-16
  halves3, turned3, size3, per3, away3, blur3, rise3, fast3, bend3, turn3, spread3 = \
      crossing_part(alpha*still - at*far, sine*slope, plain*(at*abs(far) + still*abs(alpha)), \
      plain*sine*abs(slope), 0.0, 0.0, 0.0)
  made = loose + 1.3322676295501878e-15
  halves2, turned2, size2, per2, away2, blur2, rise2, fast2, bend2, turn2, spread2 = \
      crossing_part(still*together - apart*at, n1*sine, apart_off*at + made* \
      (at*abs(apart) + still*together), sine*(made*abs(n1) + n1_off), 0.0, 0.0, 0.0)
  halves, turned, size, per, away, blur, rise, fast, bend_, turn_, spread_ = \
      crossing_part(-2.0*off*total, loss*sine, 4.0*a_off + total* \
      (2.0*free + 8.881784197001252e-16*abs(off)), loss*made*sine, 0.0, 0.0, 0.0)
  ratio = per*size2
  gap_ = 1.0 - 0.25*ratio*size3
  rough = away + away2 + away3 + 1.3322676295501878e-15
  signed = gap_ if leads > 0.0 else -gap_
  good = 1.0 if signed > 2.0*rough else 0.0
  if good < 1.0 and rest > 0.0 and y > 0.0:
    Touches_out = nan
  else:
    Touches_out = 0.0
  return Touches_out

def zone_touches(leads, x, zone, alpha, slope, far, n1, loss, together, apart, apart_off, n1_off, \
    a_off, center, beyond):
  y = x if zone == 0.0 else (center + x if zone == 1.0 else 4.0 - x)
  rest = 4.0 - x if zone == 0.0 else (beyond - x if zone == 1.0 else x)
  off = x - center if zone == 0.0 else (x if zone == 1.0 else beyond - x)
  loose = 1.7763568394002505e-15 if zone == 1.0 else 2.220446049250313e-16
  free = 0.0 if zone == 1.0 else 8.881784197001252e-16*(center if zone == 0.0 else beyond)
  ZoneTouches_out = touches(leads, y, rest, off, loose, free, alpha, slope, far, n1, loss, \
      together, apart, apart_off, n1_off, a_off)
  return ZoneTouches_out

def zone_turns(k0, k1, k2, k3, low, high, at_low, at_high, zone, alpha, slope, far, d, n1, loss, \
    together, apart, apart_off, n1_off, a_off, center, beyond):
  disc = k2*k2 - 3.0*k1*k3
  root = sqrt(max(0.0, disc))
  q = -k2 - (-root if k2 < 0.0 else root)
  some = 3.0*k3 if abs(k2) < 24.0*abs(k3) else 1.0
  at = -k2/some
  cut = at if abs(k2) < 24.0*abs(k3) and at > low and at < high else low
  some2 = 3.0*k3 if abs(q) < 24.0*abs(k3) else 1.0
  at2 = q/some2
  cut2 = at2 if abs(q) < 24.0*abs(k3) and at2 > low and at2 < high else low
  some3 = q if abs(k1) < 8.0*abs(q) else 1.0
  at3 = k1/some3
  cut3 = at3 if abs(k1) < 8.0*abs(q) and at3 > low and at3 < high else low
  less = min(cut2, cut3)
  more = max(cut2, cut3)
  first = min(cut, less)
  middle = max(cut, less)
  last = max(middle, more)
  middle2 = min(middle, more)
  p = first*(first*(first*k3 + k2) + k1) + k0
  p2 = k0 + middle2*(k1 + middle2*(k2 + k3*middle2))
  p3 = k0 + last*(k1 + last*(k2 + k3*last))
  value2 = cut3*(cut3*(cut3*k3 + k2) + k1) + k0
  if cut2 > low:
    value = cut2*(cut2*(cut2*k3 + k2) + k1) + k0
    found = zone_touches(value, cut2, zone, alpha, slope, far, n1, loss, together, apart, \
        apart_off, n1_off, a_off, center, beyond)
  else:
    found = 0.0
  found2 = found + (zone_touches(value2, cut3, zone, alpha, slope, far, n1, loss, together, \
      apart, apart_off, n1_off, a_off, center, beyond) if cut3 > low else 0.0)
  found3 = found2 + piece_turns(k0, k1, k2, k3, low, first, at_low, p, zone, alpha, slope, far, \
      d, n1, loss, together, apart, apart_off, n1_off, a_off, center, beyond)
  found4 = found3 + piece_turns(k0, k1, k2, k3, first, middle2, p, p2, zone, alpha, slope, far, \
      d, n1, loss, together, apart, apart_off, n1_off, a_off, center, beyond)
  found5 = found4 + piece_turns(k0, k1, k2, k3, middle2, last, p2, p3, zone, alpha, slope, far, \
      d, n1, loss, together, apart, apart_off, n1_off, a_off, center, beyond)
  ZoneTurns_out = found5 + piece_turns(k0, k1, k2, k3, last, high, p3, at_high, zone, alpha, \
      slope, far, d, n1, loss, together, apart, apart_off, n1_off, a_off, center, beyond)
  return ZoneTurns_out

def fractional_roots(alpha, beta, d, m2, m0, gamma, at_minus_one, loss, together, apart, across, \
    delta):
  if alpha == 0.0 and beta == 0.0:
    FractionalRoots_out = 0.0
  else:
    strength = abs(alpha) + abs(beta)
    stiffest = max(gamma, abs(alpha))
    slope = alpha + beta
    wall_far = alpha + 2.0*beta
    force = beta*slope
    lost = loss*loss
    square = m0*m2
    size = across*across
    at_one = gamma*together
    turn_off = 8.881784197001252e-16/(max(1.0, delta)* \
        sqrt(max(1.0, gamma))) if gamma > 10.0 else 0.0
    size2 = m2 + together + abs(m0)
    near = sqrt(min(1.0, at_minus_one))
    near2 = sqrt(min(1.0, at_one))
    whole = 1.0 if gamma == 0.0 else gamma
    apart_off = near*(7.105427357601002e-15*size2 + 2.0*turn_off)
    n1_off = near2*turn_off + 1.4210854715202004e-14* \
        (2.0*near2/whole if gamma > 10.0 and loss < 0.5 else 0.125*size2)
    a_off = 1.5777218104420236e-30*sqrt(at_minus_one*gamma)
    ends = m2 + abs(m0)
    apart_one = (gamma - alpha)*(alpha + gamma)
    even = together*together
    even2 = together*(m0 + m2)
    linear = size - even2
    push = alpha*alpha
    near0 = apart_one*even
    near1 = -at_one*(2.0 - loss) - force*(together*together) - linear*push + lost
    near22 = -force*linear - loss - push*square + 1.0
    near3 = -force*square
    cross = size + abs(even2)
    bent = cross*abs(force) + push*abs(square) + 1.0
    most = at_one*(2.0 - loss) + cross*push + lost + (together*together)*abs(force)
    blurred = n1_off*(n1_off + 2.0*abs(across))
    cross_off = blurred + together*turn_off
    pull = abs(apart*wall_far)
    end_off = a_off + apart_off*abs(wall_far) + 1.7763568394002505e-15*at_minus_one + \
        1.7763568394002505e-15*pull
    end_apart = abs(at_minus_one - pull) - end_off
    end_least = end_apart*(at_minus_one + pull)
    cubed = ends*turn_off*abs(force)
    room = (alpha*alpha)*cross_off + 3.552713678800501e-15*most
    product = 4.0*near0*near22
    outer = near1*near3
    pushed_ = apart*wall_far
    even3 = apart*(m0 + m2)
    linear2 = size - even3
    push2 = wall_far*wall_far
    far0 = (at_minus_one - pushed_)*(at_minus_one + pushed_)
    far1 = (apart*apart)*force - at_minus_one*(2.0 - loss) - linear2*push2 + lost
    far2 = force*linear2 - loss - push2*square + 1.0
    far3 = force*square
    cross2 = size + abs(even3)
    bent2 = cross2*abs(force) + push2*abs(square) + 1.0
    most2 = (apart*apart)*abs(force) + at_minus_one*(2.0 - loss) + cross2*push2 + lost
    cross_off2 = apart_off*ends + blurred + turn_off*abs(apart)
    room2 = 2.0*a_off + apart_off*(apart_off + 2.0*abs(apart))*abs(force) + cross_off2* \
        (wall_far*wall_far) + 3.552713678800501e-15*most2
    product2 = 4.0*far0*far2
    outer2 = far1*far3
    base = 1.7763568394002505e-14*bent2 + 5.0*cross_off2*abs(force) + 5.0*ends*turn_off* \
        (wall_far*wall_far)
    base2 = 5.0*(alpha*alpha)*ends*turn_off + 1.7763568394002505e-14*bent + 5.0*cross_off*abs(force)
    if (((stiffest > 0.0 and stiffest < 3.8725919148493183e-121) or loss + \
        strength < 3.8725919148493183e-121) and strength > 0.0) or ( \
        abs(far1) <= 1.2789769243681803e-13*bent2 + 36.0*cross_off2*abs(force) + 36.0*ends* \
        turn_off*(wall_far*wall_far) and abs(far2) <= 2.842170943040401e-14*bent2 + 8.0* \
        cross_off2*abs(force) + 8.0*ends*turn_off* \
        (wall_far*wall_far) and end_least <= 2.2737367544323206e-12*bent2 + 640.0*cross_off2* \
        abs(force) + 128.0*cubed + 640.0*ends*turn_off*(wall_far*wall_far) + 128.0* \
        abs(far3) and outer2 >= 0.0 and outer2 <= base*base) or (abs(near0) <= 640.0* \
        (alpha*alpha)*ends*turn_off + 2.2737367544323206e-12*bent + 640.0*cross_off*abs(force) + \
        128.0*cubed + 128.0*abs(near3) and abs(near1) <= 36.0*(alpha*alpha)*ends*turn_off + \
        1.2789769243681803e-13*bent + 36.0*cross_off*abs(force) and abs(near22) <= 8.0* \
        (alpha*alpha)*ends*turn_off + 2.842170943040401e-14*bent + 8.0*cross_off* \
        abs(force) and outer >= 0.0 and outer <= base2*base2) or (abs(near0) <= 8.0*room + 128.0* \
        abs(near3) and product >= 0.0 and product <= room*room and room >= abs(near1)) or ( \
        end_least <= 8.0*room2 + 128.0*abs(far3) and product2 >= 0.0 and product2 <= room2* \
        room2 and room2 >= abs(far1)) or end_apart <= 0.0:
      FractionalRoots_out = -1.0
    else:
      middle = 2.0*at_one/(2.0 - loss)
      rest = 2.0*at_minus_one/(2.0 - loss)
      sine = 0.25*middle*rest
      tilt = 0.25*rest - 0.25*middle
      real = 0.25*rest*together - 0.25*apart*middle
      one = real*real + sine*size
      two = size*tilt - real*(m0 + m2)
      wave = 0.25*alpha*rest - 0.25*middle*wall_far
      wall = sine*(slope*slope) + wave*wave
      own0 = lost*sine - one*wall
      own1 = lost*tilt - force*one - two*wall
      own2 = -force*two - loss - square*wall + 1.0
      own3 = -force*square
      one2 = 0.5*middle
      two2 = 0.5*rest
      before = own0 - one2*(own1 - one2*(own2 - one2*own3))
      after = own0 + two2*(own1 + two2*(own2 + own3*two2))
      zone = 0.0
      side = 1.0 if slope >= 0.0 else -1.0
      end = (side if wall_far > 0.0 else 0.0) - d + \
          ((1.0 if across >= 0.0 else -1.0) if apart > 0.0 else 0.0) - 3.0
      total = ((0.0 if alpha > 0.0 else side) if ( \
          (((( \
          near22 == 0.0 and near3 < 0.0) or near22 < 0.0) and near1 == 0.0) or near1 < 0.0) and near0 == 0.0) or near0 < 0.0 else 0.0) + zone_turns(far0, far1, far2, far3, zone, two2, far0, after, 2.0, alpha, slope, wall_far, d, across, loss, together, apart, apart_off, n1_off, a_off, middle, rest) + zone_turns(near0, near1, near22, near3, zone, one2, near0, before, zone, alpha, slope, wall_far, d, across, loss, together, apart, apart_off, n1_off, a_off, middle, rest) + zone_turns(own0, own1, own2, own3, -one2, two2, before, after, 1.0, alpha, slope, wall_far, d, across, loss, together, apart, apart_off, n1_off, a_off, middle, rest)
      total2 = total - (end if ((((( \
          far2 == 0.0 and far3 < 0.0) or far2 < 0.0) and far1 == 0.0) or far1 < 0.0) and far0 == 0.0) or far0 < 0.0 else 0.0)
      if total2 >= 0.0:
        FractionalRoots_out = total2
      else:
        FractionalRoots_out = -1.0
  return FractionalRoots_out

def fractional_numerator_gap(epsilon, x, x_low, y, y_low, first, last, turned):
  less, less_low = one_minus(epsilon, 0.0)
  prod, prod_low = wide_prod(epsilon, less, less_low)
  prod2, prod_low2 = pair_prod(x, x_low, y, y_low)
  prod3, prod_low3 = pair_prod(prod, prod_low, prod2, prod_low2)
  diff, diff_low = pair_diff(first, 0.0, 2.0*prod3, 2.0*prod_low3)
  diff2, diff_low2 = pair_diff(diff, diff_low, last, 0.0)
  total, total_low = pair_sum(diff2, diff_low2, turned, 0.0)
  FractionalNumeratorGap_out = rounded(total, total_low)
  return FractionalNumeratorGap_out

@lru_cache(256)
def half_turned_swing(gamma, delta, part):
  half, w, w_low, root, reach = device_motion(gamma, delta)
  total, total_low = fast_two_sum(1.0, -part)
  angle = 0.5*root
  angle_low = 0.5*root_miss(w, w_low, root)
  prod, prod_low = pair_prod(angle, angle_low, total, total_low)
  prod2, prod_low2 = pair_prod(angle, angle_low, part, 0.0)
  wave = sin(angle)
  still = cos(angle)
  sine = angle_low*still + wave
  cosine = still - angle_low*wave
  wave2 = sin(prod)
  still2 = cos(prod)
  sine2 = prod_low*still2 + wave2
  cosine2 = still2 - prod_low*wave2
  wave3 = sin(prod2)
  still3 = cos(prod2)
  sine3 = prod_low2*still3 + wave3
  cosine3 = still3 - prod_low2*wave3
  along = cosine2*cosine3 + sine2*sine3
  across = cosine3*sine2 - cosine2*sine3
  before = 0.5 - part
  step = expm1(0.5*half)
  weak = 0.5*step + 0.5*step/(step + 1.0)
  more = 0.5*(step*step)/(step + 1.0)
  strong = more + 1.0
  fallen = expm1(-before*half)
  grown = fallen + 1.0
  ratio = half/root
  lost = weak*weak - along*cosine*(fallen*strong + more)
  turned = grown*sine*weak*(across - along*ratio)
  kept = across*cosine*grown*ratio*strong
  total2 = -2.0*cosine*sine2*sine3 - kept + lost + turned
  HalfTurnedSwing_out = 4.0*total2*exp(-half)/gamma
  return HalfTurnedSwing_out

def half_turned(found, gamma, delta, part):
  half, w, w_low, root, reach = device_motion(gamma, delta)
  if half < 0.25 and root > 3.0 and w < 0.0:
    HalfTurned_out = half_turned_swing(gamma, delta, part)
  else:
    HalfTurned_out = found
  return HalfTurned_out

@lru_cache(256)
def device_kick_kick_low_n_gap_n0_n1(gamma, delta):
  half, w, w_low, root, reach = device_motion(gamma, delta)
  if w < 0.0:
    envelope, even, even_low, wave, wave_low, near, risen, sunk, moved = \
        swinging_device(gamma, half, w, w_low, root)
    prod, prod_low = wide_prod(envelope, wave, wave_low)
    total, total_low = fast_two_sum(prod, prod_low)
    decayed, decayed_low = slow_fade(reach, half)
    kick__out = total
    kick_low__out = total_low
    n_gap_out = numerator_gap_swing(reach, half, w, envelope, wave, wave_low, gamma, delta)
    n0_out = plant_n0_swing(reach, half, envelope, even, even_low, wave, wave_low, near, sunk, \
        decayed, decayed_low, gamma)
    n1_out = plant_n1_swing(reach, half, w, envelope, even, even_low, wave, wave_low, near, \
        risen, decayed, decayed_low, gamma)
  else:
    p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far, far_low = \
        creeping_device(gamma, half, w, w_low, root)
    prod2, prod_low2 = pair_prod(slow, slow_low, far, far_low)
    total2, total_low2 = fast_two_sum(prod2, prod_low2)
    decayed, decayed_low = slow_fade(reach, half)
    kick__out = total2
    kick_low__out = total_low2
    n_gap_out = numerator_gap_creep(reach, half, w, p, slow, mean, mean_low, ratio, far, far_low, \
        delta)
    n0_out = plant_n0_creep(reach, p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, \
        far, far_low, decayed, decayed_low, gamma, delta)
    n1_out = plant_n1_creep(reach, half, w, p, p_low, slow, slow_low, mean, mean_low, far, \
        far_low, decayed, decayed_low)
  return kick__out, kick_low__out, n_gap_out, n0_out, n1_out

@lru_cache(256)
def late_device(gamma, delta, part):
  t0 = 1.0 - part
  t1 = t0*t0
  t2 = gamma*t1
  t3 = delta*t0
  kick_of, kick_low_of, n_gap, n0_2, n1 = device_kick_kick_low_n_gap_n0_n1(t2, t3)
  t5 = part*part
  t6 = gamma*t5
  t7 = delta*part
  kick_of2, kick_low_of2, n_gap_2, n0, n1_2 = device_kick_kick_low_n_gap_n0_n1(t6, t7)
  t9 = n0*t5
  apart_out = half_turned(fractional_numerator_gap(part, kick_of, kick_low_of, kick_of2, \
      kick_low_of2, delta*n_gap*(t0*t0*t0), delta*n_gap_2*(part*part*part), n0_2*t1* \
      (kick_of2*t7 + n1_2*t6) + n1*n1_2*t2*t5 - t3*t9*decay(t3)), gamma, delta, part)
  m2_out = n1*t1
  kicked_out = kick_of*t0
  m0_out = t9*exp(-t3)
  return apart_out, m2_out, kicked_out, m0_out

def stable(roots, alpha, beta, gamma, delta):
  swing = sqrt(gamma)
  yes = 1.0 if alpha > -gamma and not ( \
      alpha == 0.0 and beta == 0.0 and delta == 0.0 and gamma > 0.0) and not ( \
      delta < 1.1102230246251565e-15 and gamma > 1.0 and swing >= 2251799813685248.0* \
      abs(sin(swing))) and roots == 0.0 else 0.0
  Stable_out = yes - (0.0 if ( \
      alpha == 0.0 and beta == 0.0 and delta == 0.0 and gamma > 0.0) or alpha <= -gamma or roots > 0.0 or yes > 0.0 else 1.0)
  return Stable_out

def nearest_point(y, rest, off, center, beyond):
  edge = y if rest > y else rest
  inside = 1.0 if beyond - off > 0.0 and center + off > 0.0 and edge > abs(off) else 0.0
  at_out = center + off if inside > 0.0 else (y if rest > y else 4.0 - rest)
  still_out = beyond - off if inside > 0.0 else (4.0 - y if rest > y else rest)
  away_out = off if inside > 0.0 else (y - center if rest > y else beyond - rest)
  loose_out = 1.7763568394002505e-15 if inside > 0.0 else 2.220446049250313e-16
  free_out = 0.0 if inside > 0.0 else 8.881784197001252e-16*(center if rest > y else beyond)
  there_out = 1.0 if min(rest, y) < 4.0 and rest > 0.0 and y > 0.0 else 0.0
  return at_out, still_out, away_out, loose_out, free_out, there_out

def bottom_touches(leads, y, rest, off, center, beyond, alpha, slope, far, n1, loss, together, \
    apart, a_off):
  at, still, away, loose, free, there = nearest_point(y, rest, off, center, beyond)
  if there > 0.0:
    BottomTouches_out = touches(leads, at, still, away, loose, free, alpha, slope, far, n1, loss, \
        together, apart, 0.0, 0.0, a_off)
  else:
    BottomTouches_out = 0.0
  return BottomTouches_out

def crossing_turns(y, rest, off, center, beyond, alpha, slope, far, d, n1, loss, together, apart, \
    a_off):
  at, still, away, loose, free, there = nearest_point(y, rest, off, center, beyond)
  if there > 0.0:
    CrossingTurns_out = phase_turns(at, still, away, loose, free, alpha, slope, far, d, n1, loss, \
        together, apart, 0.0, 0.0, a_off)
  else:
    CrossingTurns_out = 0.0
  return CrossingTurns_out

def quadratic_roots(c, b, a, root):
  q = -0.5*b - 0.5*(root if b >= 0.0 else -root)
  lead_ = 1.0 if a == 0.0 else a
  own = 1.0 if q == 0.0 else q
  one = -1.0 if a == 0.0 else q/lead_
  two = -1.0 if q == 0.0 else c/own
  if b >= 0.0:
    low_out = one
    high_out = two
  else:
    low_out = two
    high_out = one
  return low_out, high_out

def whole_roots(alpha, beta, d, n1, n0, gamma, at_minus_one, loss, together, apart):
  if alpha == 0.0 and beta == 0.0:
    WholeRoots_out = 0.0
  else:
    strength = abs(alpha) + abs(beta)
    stiffest = max(gamma, abs(alpha))
    e = 1.0 - loss
    slope = alpha + beta
    wall_far = alpha + 2.0*beta
    force = beta*slope
    cross = n0*n1
    lost = loss*loss
    square = cross*force + e
    at_one = gamma*together
    even = together*together
    pull = apart*wall_far
    near1 = (alpha*alpha)*cross - at_one*(e + 1.0) - even*force + lost
    near1_size = abs(lost) + abs((alpha*alpha)*cross) + abs(at_one*(e + 1.0)) + abs(even*force)
    apart_one = (gamma - alpha)*(alpha + gamma)
    near0 = apart_one*even
    far1 = (apart*apart)*force - at_minus_one*(e + 1.0) - cross*(wall_far*wall_far) + lost
    far1_size = abs(lost) + abs((apart*apart)*force) + abs(at_minus_one*(e + 1.0)) + \
        abs(cross*(wall_far*wall_far))
    far0 = (at_minus_one - pull)*(at_minus_one + pull)
    center = 2.0*at_one/(e + 1.0)
    beyond = 2.0*at_minus_one/(e + 1.0)
    sine = 0.25*beyond*center
    tilt = 0.25*beyond - 0.25*center
    real = 0.25*beyond*together - 0.25*apart*center
    m0 = (n1*n1)*sine + real*real
    m1 = (n1*n1)*tilt - n1*real
    wave = 0.25*alpha*beyond - 0.25*center*wall_far
    wall = sine*(slope*slope) + wave*wave
    own0 = lost*sine - m0*wall
    own1 = lost*tilt - force*m0 - m1*wall
    own2 = e - force*m1
    a_off = 1.5777218104420236e-30*sqrt(at_minus_one*gamma)
    pull2 = abs(apart*wall_far)
    end_off = a_off + 1.7763568394002505e-15*at_minus_one + 1.7763568394002505e-15*pull2
    end_apart = abs(at_minus_one - pull2) - end_off
    end_least = end_apart*(at_minus_one + pull2)
    room = 3.552713678800501e-15*near1_size
    product = 4.0*near0*square
    room2 = 2.0*a_off + 3.552713678800501e-15*far1_size
    product2 = 4.0*far0*square
    square2 = near1*near1
    product3 = 4.0*near0*square
    size = square2 + abs(product3)
    square3 = own1*own1
    product4 = 4.0*own0*own2
    size2 = square3 + abs(product4)
    square4 = far1*far1
    product5 = 4.0*far0*square
    size3 = square4 + abs(product5)
    odd2 = abs((1.0 if ((( \
        far1 == 0.0 and square < 0.0) or far1 < 0.0) and far0 == 0.0) or far0 < 0.0 else 0.0) - \
        (1.0 if ((( \
        near1 == 0.0 and square < 0.0) or near1 < 0.0) and near0 == 0.0) or near0 < 0.0 else 0.0))
    if size >= size2 and size2 <= size3:
      disc4 = square3 - product4
    else:
      if size > size3 and size2 > size3:
        disc4 = square4 - product5
      else:
        disc4 = square2 - product3
    positive = disc4 if disc4 >= 0.0 else 0.0
    root = sqrt(positive)
    low, high = quadratic_roots(near0, near1, square, root)
    low3, high3 = quadratic_roots(far0, far1, square, root)
    odd = abs((1.0 if disc4 >= 0.0 and high > 0.0 and low3 > 0.0 and min(high, \
        low3) < 4.0 else 0.0) - (1.0 if disc4 >= 0.0 and high3 > 0.0 and low > 0.0 and min(high3, \
        low) < 4.0 else 0.0))
    if (((stiffest > 0.0 and stiffest < 3.8725919148493183e-121) or loss + \
        strength < 3.8725919148493183e-121) and strength > 0.0) or (abs(near0) <= 8.0* \
        room and product >= 0.0 and product <= room*room and room >= abs(near1)) or ( \
        end_least <= 8.0*room2 and product2 >= 0.0 and product2 <= room2* \
        room2 and room2 >= abs(far1)) or end_apart <= 0.0 or odd != odd2:
      WholeRoots_out = -1.0
    else:
      side = 1.0 if slope >= 0.0 else -1.0
      end = (side if wall_far > 0.0 else 0.0) - d + \
          ((1.0 if n1 >= 0.0 else -1.0) if apart > 0.0 else 0.0) - 3.0
      if disc4 >= 0.0:
        low2, high2 = quadratic_roots(own0, own1, own2, root)
        total = 2.0*crossing_turns(low, high3, low2, center, beyond, alpha, slope, wall_far, d, \
            n1, loss, together, apart, a_off) - 2.0* \
            crossing_turns(high, low3, high2, center, beyond, alpha, slope, wall_far, d, n1, \
            loss, together, apart, a_off)
      else:
        if square == 0.0:
          bottom = -1.0
          bottom2 = -1.0
        else:
          bottom = -0.5*near1/square
          bottom2 = -0.5*far1/square
        if own2 == 0.0:
          bottom3 = -1.0
        else:
          bottom3 = -0.5*own1/own2
        total = bottom_touches(square, bottom, bottom2, bottom3, center, beyond, alpha, slope, \
            wall_far, n1, loss, together, apart, a_off)
      total2 = total + ((0.0 if alpha > 0.0 else side) if ( \
          (( \
          near1 == 0.0 and square < 0.0) or near1 < 0.0) and near0 == 0.0) or near0 < 0.0 else 0.0)
      total3 = total2 - (end if ((( \
          far1 == 0.0 and square < 0.0) or far1 < 0.0) and far0 == 0.0) or far0 < 0.0 else 0.0)
      if total3 >= 0.0:
        WholeRoots_out = total3
      else:
        WholeRoots_out = -1.0
  return WholeRoots_out

def ahead_in_phase(psi, at_one, at_minus_one, loss, together, apart, across):
  t = tan(psi)
  square = t*t
  low = two_prod_error(t, t)
  diff, diff_low = two_diff(at_one, at_minus_one*square)
  missed = at_minus_one*low + two_prod_error(at_minus_one, square)
  total, total_low = fast_two_sum(diff, diff_low - missed)
  diff2, diff_low2 = two_diff(together, apart*square)
  missed2 = apart*low + two_prod_error(apart, square)
  total2, total_low2 = fast_two_sum(diff2, diff_low2 - missed2)
  above_j = 2.0*loss*t
  below_j = across*t
  rest = below_j*below_j + 2.0*total2*total_low2
  size = rest + total2*total2
  low2 = above_j*total_low2 - below_j*total_low
  found = above_j*total2 - below_j*total
  found2 = found + low2
  low22 = total*total_low2 + total2*total_low
  rest2 = above_j*below_j + low22
  found3 = rest2 + total*total2
  ahead__out = found2/size
  in_phase__out = found3/size
  return ahead__out, in_phase__out

@lru_cache(256)
def device_at_minus_one_kick_together_n_gap(gamma, delta):
  half, w, w_low, root, reach = device_motion(gamma, delta)
  if w < 0.0:
    envelope, even, even_low, wave, wave_low, near, risen, sunk, moved = \
        swinging_device(gamma, half, w, w_low, root)
    prod, prod_low = wide_prod(envelope, wave, wave_low)
    at_minus_one_out = denominator_at_minus_one_swing(half, w, w_low, root, envelope, even, \
        even_low)
    kick__out = rounded(prod, prod_low)
    together_out = numerator_at_one_swing(reach, half, w, w_low, root, envelope, near, moved, gamma)
    n_gap_out = numerator_gap_swing(reach, half, w, envelope, wave, wave_low, gamma, delta)
  else:
    p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far, far_low = \
        creeping_device(gamma, half, w, w_low, root)
    prod2, prod_low2 = pair_prod(slow, slow_low, far, far_low)
    at_minus_one_out = denominator_at_minus_one_creep(slow, slow_low, ratio, ratio_low)
    kick__out = rounded(prod2, prod_low2)
    together_out = numerator_at_one_creep(reach, half, w, p, p_low, slow, slow_low, mean, \
        mean_low, ratio, ratio_low)
    n_gap_out = numerator_gap_creep(reach, half, w, p, slow, mean, mean_low, ratio, far, far_low, \
        delta)
  return at_minus_one_out, kick__out, together_out, n_gap_out

def next_wave(k, x):
  count = k + 1.0
  before = count - 1.0
  angle = count*x
  missed = k - before
  off = missed*x + two_prod_error(count, x)
  sine = sin(angle)
  cosine = cos(angle)
  if abs(off) < 7.450580596923828e-09:
    cosine_out = cosine - off*sine
    sine_out = cosine*off + sine
  else:
    cosine_out = cosine*cos(off) - sine*sin(off)
    sine_out = cosine*sin(off) + sine*cos(off)
  return cosine_out, sine_out

def cos_next(k, x):
  cosine, sine = next_wave(k, x)
  CosNext_out = cosine
  return CosNext_out

def gap(x):
  if abs(x) < 2.0:
    square = -(x*x)
    total = 0.0
    for number in inverse_factorial[slice(25, 5 - 1, -2)]:
      next_total = number + square*total
      total = next_total
    rest = square*total + 9.25185853854297e-18
    Gap_out = rest + 0.16666666666666666
  else:
    Gap_out = (x - sin(x))/(x*x*x)
  return Gap_out

def sinc(x):
  if abs(x) < 1.0:
    Sinc_out = 1.0 - (x*x)*gap(x)
  else:
    Sinc_out = sin(x)/x
  return Sinc_out

def damping_at(alpha, beta, l, epsilon, psi):
  early = 0.5*alpha*(2.0*l + 1.0)*sinc(psi*(2.0*l + 1.0))/sinc(psi) - beta*cos_next(l, 2.0*psi)
  if epsilon == 0.0:
    DampingAt_out = early
  else:
    n = early + epsilon*(0.5*alpha*(2.0*l + 3.0)*sinc(psi*(2.0*l + 3.0))/sinc(psi) - beta* \
        cos_next(l + 1.0, 2.0*psi) - early)
    base = sin(psi)
    base2 = cos(psi)
    base3 = alpha + 2.0*beta
    root = sqrt(epsilon*(1.0 - epsilon)*((alpha*alpha)*(base2*base2) + (base*base)* \
        (base3*base3)) + n*n)
    DampingAt_out = 0.5*n + 0.5*root
  return DampingAt_out

def next_guess(b, fb, a, fa, c, fc, close):
  span = c - b
  rise = fc - fb
  whole = 1.0 if span == 0.0 else span
  place = (a - b)/whole
  whole2 = 1.0 if rise == 0.0 else rise
  height = (fa - fb)/whole2
  base = 1.0 - height
  safe = 1.0 if place > height*height and place < 1.0 - (base*base) else 0.0
  width = b - a
  whole3 = 1.0 if width == 0.0 else width
  edge = close*abs(a if abs(fa) < abs(fb) else b)/abs(whole3)
  edge2 = min(0.5, edge)
  if safe > 0.0:
    one = fb - fa
    two = fb - fc
    three = fa - fc
    here = fa/one
    there = fc/two
    other = fa/three
    last = fb/two
    guess = here*there + last*other*(c - a)/whole3
  else:
    guess = 0.5
  share = min(guess, 1.0 - edge2)
  share2 = max(edge2, share)
  NextGuess_out = a + share2*width
  return NextGuess_out

def sin_next(k, x):
  cosine, sine = next_wave(k, x)
  SinNext_out = sine
  return SinNext_out

def chord(k, x):
  turn_ = x*(k + 1.0)
  order = 2.0*k + 2.0
  along = cos_next(k, x)
  if turn_ < 1.5:
    wave = sinc(0.5*turn_)
    inner = 0.5*(wave*wave) - gap(turn_)
    Chord_out = order*(along*gap(x) + 0.25*inner*(order*order))
  else:
    Chord_out = (2.0*sin_next(k, x) - along*order*sin(x))/(x*x*x)
  return Chord_out

def rising(alpha, beta, l, epsilon, psi):
  t = 2.0*psi
  base = sinc(psi)
  t2 = 2.0*alpha/(base*base)
  t3 = 0.5*alpha + beta
  t4 = 2.0*l
  t5 = t4 + 2.0
  t6 = t4 + 4.0
  early = t3*(t5*t5)*sinc(psi*t5) - t2*chord(l, t)
  steep = early + epsilon*(-early - t2*chord(l + 1.0, t) + t3*(t6*t6)*sinc(psi*t6))
  Rising_out = 2.0*beta*epsilon*(1.0 - epsilon)*(alpha + beta)*sinc(2.0*psi) + steep* \
      damping_at(alpha, beta, l, epsilon, psi)
  return Rising_out

def steepness(alpha, beta, l, epsilon, psi):
  if epsilon == 0.0:
    t = 2.0*l + 2.0
    base = sinc(psi)
    Steepness_out = (t*t)*(0.5*alpha + beta)*sinc(psi*t) - 2.0*alpha*chord(l, 2.0*psi)/(base*base)
  else:
    rising_ = rising(alpha, beta, l, epsilon, psi)
    phase = psi*(2.0*l + 2.0) + atan2(alpha*cos(psi), (alpha + 2.0*beta)*sin(psi)) + \
        atan2(epsilon*sin(2.0*psi), epsilon*cos(2.0*psi) - epsilon + 1.0) - 3.141592653589793
    if phase > 0.0:
      Steepness_out = -abs(rising_)
    else:
      Steepness_out = rising_
  return Steepness_out

def worst_angle(alpha, beta, l, epsilon):
  size = abs(alpha) + abs(beta)
  whole = 1.0 if size == 0.0 else size
  stiffness = alpha/whole
  damping = beta/whole
  low = 0.0
  above = steepness(stiffness, damping, l, epsilon, low)
  if above <= 0.0:
    WorstAngle_out = low
  else:
    high = 3.141592653589793/(2.0*l + 2.0)
    below = steepness(stiffness, damping, l, epsilon, high)
    if below >= 0.0:
      WorstAngle_out = high
    else:
      b = low
      fb = above
      a = high
      fa = below
      c = high
      fc = below
      for count_b in range(120):
        if (fa >= 0.0 and fb >= 0.0) or (fa <= 0.0 and fb <= 0.0) or abs(a - \
            b) <= 4.656612873077393e-10*abs(a if abs(fa) < abs(fb) else b):
          break
        new = next_guess(b, fb, a, fa, c, fc, 4.656612873077393e-10)
        value = steepness(stiffness, damping, l, epsilon, new)
        same = 1.0 if (fa > 0.0 and value > 0.0) or (fa < 0.0 and value < 0.0) else 0.0
        next_b = b if same > 0.0 else a
        next_fb = fb if same > 0.0 else fa
        next_c = a if same > 0.0 else b
        next_fc = fa if same > 0.0 else fb
        fc = next_fc
        c = next_c
        fa = value
        a = new
        fb = next_fb
        b = next_b
      if abs(fa) < abs(fb):
        WorstAngle_out = a
      else:
        WorstAngle_out = b
  return WorstAngle_out

def largest_required_damping(alpha, beta, d):
  if alpha < 0.0:
    LargestRequiredDamping_out = inf
  else:
    whole = floor(d)
    part = d - whole
    lift = 6.668014432879854e+240 if abs(alpha) + abs(beta) < 3.8725919148493183e-121 else 1.0
    stiffness = alpha*lift
    damping = beta*lift
    LargestRequiredDamping_out = damping_at(stiffness, damping, whole, part, \
        worst_angle(stiffness, damping, whole, part))/lift
  return LargestRequiredDamping_out

def discretize(gamma, delta):
  if not (delta >= 0.0 and delta <= 1e+70 and gamma >= 0.0 and gamma <= 1e+15):
    return None
  n0, n1, trace = device_n0_n1_trace(gamma, delta)
  n1_out = n1
  n0_out = n0
  a_out = trace
  e_out = exp(-delta)
  return n1_out, n0_out, a_out, e_out

def is_stable(alpha, beta, gamma, delta, d):
  if not (abs(alpha) <= 1e+70 and abs( \
      beta) <= 1e+70 and d >= 0.0 and d <= 1e+15 and delta >= 0.0 and delta <= 1e+70 and gamma >= 0.0 and gamma <= 1e+15):
    return None
  at_minus_one, kick_of, together, n_gap, n0, n1 = \
      device_at_minus_one_kick_together_n_gap_n0_n1(gamma, delta)
  whole = floor(d)
  part = d - whole
  t1 = delta*decay(delta)
  t3 = delta*n_gap
  if part == 0.0:
    stable__out = stable(whole_roots(alpha, beta, d, n1, n0, gamma, at_minus_one, t1, together, \
        t3), alpha, beta, gamma, delta) > 0.0
  else:
    apart, m2, kicked, m0 = late_device(gamma, delta, part)
    stable__out = stable(fractional_roots(alpha, beta, whole, m2, m0, gamma, at_minus_one, t1, \
        together, apart, 0.5*kick_of*(delta*m2 + 2.0*kicked) + 0.5*m2*(gamma*together + t1) - 0.5* \
        together + 0.5*t3, delta), alpha, beta, gamma, delta) > 0.0
  return stable__out

def unstable_roots(alpha, beta, gamma, delta, d):
  if not (abs(alpha) <= 1e+70 and abs( \
      beta) <= 1e+70 and d >= 0.0 and d <= 1e+15 and delta >= 0.0 and delta <= 1e+70 and gamma >= 0.0 and gamma <= 1e+15):
    return None
  at_minus_one, kick_of, together, n_gap, n0, n1 = \
      device_at_minus_one_kick_together_n_gap_n0_n1(gamma, delta)
  whole = floor(d)
  part = d - whole
  t1 = delta*decay(delta)
  t3 = delta*n_gap
  if part == 0.0:
    roots_out = whole_roots(alpha, beta, d, n1, n0, gamma, at_minus_one, t1, together, t3)
  else:
    apart, m2, kicked, m0 = late_device(gamma, delta, part)
    roots_out = fractional_roots(alpha, beta, whole, m2, m0, gamma, at_minus_one, t1, together, \
        apart, 0.5*kick_of*(delta*m2 + 2.0*kicked) + 0.5*m2*(gamma*together + t1) - 0.5* \
        together + 0.5*t3, delta)
  return roots_out

def stability_boundary(theta, gamma, delta, d):
  if not ( \
      d >= 0.0 and d <= 1e+15 and delta >= 0.0 and delta <= 1e+70 and gamma >= 0.0 and gamma <= 1e+15 and theta > 0.0 and theta <= 3.141592653589793):
    return None
  at_minus_one, kick_of, together, n_gap = device_at_minus_one_kick_together_n_gap(gamma, delta)
  whole = floor(d)
  cosine, sine = next_wave(whole, theta)
  part = d - whole
  t2 = 0.5*theta
  t4 = gamma*together
  t6 = delta*decay(delta)
  t7 = delta*n_gap
  if part == 0.0:
    t10 = t7
    t12 = together + t7
  else:
    apart, m2, kicked, m0 = late_device(gamma, delta, part)
    t10 = apart
    t12 = kick_of*(delta*m2 + 2.0*kicked) + m2*(t4 + t6) - together + t7
  ahead_of, in_phase_of = ahead_in_phase(t2, t4, at_minus_one, t6, together, t10, t12)
  t16 = ahead_of*cosine + in_phase_of*sine
  alpha_out = ahead_of*sine - cosine*in_phase_of + t16*tan(t2)
  beta_out = -t16/sin(theta)
  return alpha_out, beta_out

def passivity_margin(alpha, beta, delta, d):
  if not (abs(alpha) <= 1e+70 and abs( \
      beta) <= 1e+70 and d >= 0.0 and d <= 1e+15 and delta >= 0.0 and delta <= 1e+70):
    return None
  margin_out = delta - largest_required_damping(alpha, beta, d)
  return margin_out
