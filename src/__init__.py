"""The modules of the assignment, and its honor roll.

Read them in this order: pds_helper, special_cradles, swinging, visualize_cradle_run.
"""
