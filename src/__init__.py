"""The handout's modules, in its order: pds_helper, special_cradles, swinging, visualize_cradle_run.

double_cradle and visualize_double_cradle_run are the honor roll. text_cradle_run shows the cradle in the terminal.
beyond/ has the additions to the handout.
"""
