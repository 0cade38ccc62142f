"""The handout's modules, in its order: pds_helper, special_cradles, swinging, visualize_cradle_run;
its honor roll.
"""
