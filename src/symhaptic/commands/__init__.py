"""The commands, each thin: it parses, calls, prints."""
