#!/usr/bin/env bash
# What does the container need before the first submission comes? Rust, and the grader built. Gradescope runs this once, as root, with network.
set -euo pipefail

source="${AUTOGRADER:-/autograder}/source"

apt-get update
apt-get install -y --no-install-recommends build-essential ca-certificates curl

curl --proto '=https' --tlsv1.2 --silent --show-error --fail https://sh.rustup.rs |
    sh -s -- -y --profile minimal --default-toolchain @TOOLCHAIN@
export PATH="${CARGO_HOME:-$HOME/.cargo}/bin:$PATH"

# The first command builds the grader; later ones find it built and need no network.
cd "$source/lightlab"
cargo fetch --locked
cargo lab grade --help >/dev/null
