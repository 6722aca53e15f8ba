"""Targets: how a Program is spelled in a language and a precision, and which files hold it."""
