#!/bin/sh
# MPI: mpi.sh STACK OUT PIECES [PLAN OPTIONS]; RANKS of them (2), started by MPIRUN ("mpirun"),
# PROGRAM being what mpi_pieces.cpp was compiled to. After a failure the same command again makes
# what is missing.
set -eu
here=$(dirname "$0") tetloft=${TETLOFT:-tetloft} stack=$1 out=$2 pieces=$3 work=$2.pieces
shift 3
mkdir -p "$work"
"$tetloft" plan "$stack" -o "$work/plan" --json "$@" >"$work/plan.json"
"$here/ranges" "$work/plan.json" "$pieces" >"$work/ranges"

# shellcheck disable=SC2086  # words of a command
${MPIRUN:-mpirun} -n "${RANKS:-2}" ${PROGRAM:-mpi_pieces} "$work/plan" "$work/ranges" "$work"

"$here/join_pieces" "$work" "$out"
