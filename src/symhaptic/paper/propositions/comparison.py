"""The claims of Sec. V: passivity beside stability."""
