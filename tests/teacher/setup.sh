#!/usr/bin/env bash
set -e && cd "$(dirname "$0")"
python3 -c "import ensurepip, venv" || { apt-get update && apt-get install -y python3 python3-venv; }
python3 -m venv ../venv
../venv/bin/pip install -q --no-deps -r support/requirements.txt && ../venv/bin/pip install -q "pytest>=8.4"
