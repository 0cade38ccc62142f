"""The handout's own modules, in its order: pds_helper, special_cradles, swinging, visualize_cradle_run."""
