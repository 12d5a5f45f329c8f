"""How is it told?  What chapters are made of: the lemmas that several of them apply.

May import notation, paper, model and proof; the derivations import from here.
"""
