"""The handout's own modules, in its order: pds_helper, special_cradles, swinging, visualize_cradle_run.

double_cradle and visualize_double_cradle_run are its honor roll, and text_cradle_run is the cradle in the terminal.
What the programs need beyond the handout is in beyond/.
"""
