#!/usr/bin/env bash
set -e && cd "$(dirname "$0")"
python=python3
python3 -c "import ensurepip, venv" || { apt-get update && apt-get install -y python3 python3-venv; }
if python3 -c "import sys; sys.exit(sys.version_info >= (3, 11))"; then
    python=python3.11 # Ubuntu 22.04, the default at Gradescope, has 3.10 and 3.11
    apt-get update && apt-get install -y $python $python-venv
fi
$python -m venv ../venv
../venv/bin/pip install -q --no-deps -r support/requirements.txt && ../venv/bin/pip install -q "pytest>=8.4"
