"""What the handout calls provided: constants, pendulum objects, the CSV's rules, and the viewer's parts."""
