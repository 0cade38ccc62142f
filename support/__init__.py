"""The functions that the handout provides, and the folders of the programs.

Words
    hit            a call of handle_two_bobs, or of handle_two_double_bobs, that changes the
                   velocities of two pendula; its record (hits.py) says who hits whom, and how fast
    fast           of a hit: its speed is at least a tenth of that of the fastest bob
    series         hits that follow each other quickly
    frame          one picture, with the ticks that come before it
    batch          ticks of a frame that are done without a look at the cradle
    lifted         the number of bobs that are released, from the left; the others hang
    release angle  the angle of the lifted cords from straight down, positive outwards, away from
                   the other pendula (degrees)
    run            a program from its top to the end of its loop, for one cradle
    film           pictures of a run, in a file that any browser plays
    page           the page in the browser
    check          one of the graded checks that pytest runs; a function that refuses bad data is
                   named require_...
"""
