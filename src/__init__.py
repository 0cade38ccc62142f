"""The handout's own modules, in its order: pds_helper, special_cradles, swinging, visualize_cradle_run.

Beyond the handout's basic part are double_cradle, its honor roll, and visualize_double_cradle_run, which shows that;
live_cradle and live_double_cradle, the cradles as the page plays with them; dragging, a bob taken by hand; and
text_cradle_run, the cradle in the terminal.
"""
