"""The handout's own modules, in its order: pds_helper, special_cradles, swinging, visualize_cradle_run.

Beyond the handout are live_cradle, the cradle as the page plays with it, and dragging, a bob taken by hand.
"""
