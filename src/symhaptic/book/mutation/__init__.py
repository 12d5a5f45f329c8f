"""Do the checkers say no?  Statements asked again with one thing changed."""
