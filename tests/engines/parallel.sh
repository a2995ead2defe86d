#!/bin/sh
# GNU parallel: parallel.sh STACK OUT PIECES [PLAN OPTIONS]. As many pieces at once as there are
# cores; one that fails or is killed is tried again, up to three times in all. With
# `--sshloginfile` the same line uses other machines that see the folder.
set -eu
here=$(dirname "$0") tetloft=${TETLOFT:-tetloft} stack=$1 out=$2 pieces=$3 work=$2.pieces
shift 3
mkdir -p "$work"
"$tetloft" plan "$stack" -o "$work/plan" --json "$@" >"$work/plan.json"
"$here/ranges" "$work/plan.json" "$pieces" >"$work/ranges"

parallel --retries 3 -q "$tetloft" reconstruct "$stack" --plan "$work/plan" --slabs {} -o "$work"/{}.vtu --threads 1 --quiet <"$work/ranges"

"$here/join_pieces" "$work" "$out"
