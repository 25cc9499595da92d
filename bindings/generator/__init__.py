"""Writes everything that follows from the API table, one module per output language."""
