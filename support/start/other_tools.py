"""Lines that are for another tool than Python, as people copy them into a Python file."""

import re

WORDS = {  # how such a line begins, in small or capital letters, and what to say of it
    r"(web ?vpython|glowscript)\b": "This line is for Web VPython (GlowScript). Delete it.",
    r"[!%]+[a-z]|\?+\w|get_ipython\(": "This line is for a notebook (Jupyter, Colab). Delete it.",
    r">>>|\.\.\.(:|(?= |$))|(in|out) ?\[[\d ]*\] ?:": (
        "{} is a prompt, and no part of a program. Delete it in front of each line."
    ),
    "```|~~~": "{} marks code in a chat or a web page. Delete this line.",
    r"\$ |(ps )?[a-z]:\\|(\([\w.-]+\) )?\w+@\w+:|"
    r"(pip3?|conda|uv|python3?|py) +(-\w|install|activate|run|\S+\.py)": (
        "This line is a command for a terminal. Delete it."
    ),
}


def of_other_tool(line: str) -> str:
    """Return what a line is that Python cannot run, if it is for another tool, or ""."""
    for start, words in WORDS.items():
        found = re.match(start, line.strip(), re.IGNORECASE)
        if found:
            return words.format(found[0])
    return ""
