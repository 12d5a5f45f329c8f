def largest_stiffness(axes): pass
def passive_regions(axes): pass
