#!/usr/bin/env bash
# For Ubuntu 22.04, the default at Gradescope
set -e && cd "$(dirname "$0")"
apt-get update && apt-get install -y python3.11-venv && python3.11 -m venv ../venv
../venv/bin/pip install -q --no-deps -r support/requirements.txt && ../venv/bin/pip install -q "pytest>=8.4"
