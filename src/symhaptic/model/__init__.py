"""First principles only: plant, hold, wall, loop and energy balance.  Never looks at the paper."""
