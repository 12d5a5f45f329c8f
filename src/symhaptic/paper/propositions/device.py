"""The claims of Sec. II and IV-A to IV-C: wall, delay, device and arm."""
