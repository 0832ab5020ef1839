"""Figures that only the chapters need: a module a part of the book, a function a figure."""
