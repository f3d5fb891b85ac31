"""Defects that are planted into whole programs; planting.md beside this folder says how."""
