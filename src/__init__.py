"""The handout's modules, and its honor roll.

Read them in the handout's order: pds_helper, special_cradles, swinging, visualize_cradle_run.
"""
