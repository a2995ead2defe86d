# To be sourced: with_ENGINE STACK OUT PIECES [PLAN OPTIONS] makes OUT by the engine. Needs TETLOFT and
# what need_ENGINE FOLDER found or made there; that fails where the engine is missing, with a word.
engines=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
all_engines="parallel make mpi slurm snakemake"

have() {
  local program
  for program in "$@"; do
    command -v "$program" >/dev/null || { echo "skipped: no $program"; return 1; }
  done
}

need_parallel() { have parallel; }
need_make() { have make; }
need_snakemake() { have snakemake; }
need_slurm() { have slurmctld slurmd sbatch munged python3; }
need_mpi() { # its program is compiled as its first lines say, with a library that is not installed
  have mpirun mpicxx || return
  [ -e "$TETLOFT_LIBRARY" ] || { echo "skipped: no $TETLOFT_LIBRARY"; return 1; }
  mpicxx -std=c++20 -O2 -Wall -Wextra "$engines/mpi_pieces.cpp" -o "$1/mpi_pieces" \
    -I"$engines/../../include" "$TETLOFT_LIBRARY" -pthread ${TETLOFT_FLAGS:-}
  PROGRAM="$1/mpi_pieces"
}

with_parallel() { "$engines/parallel.sh" "$@"; }
with_make() {
  make -s -f "$engines/Makefile" -j2 "TETLOFT=$TETLOFT" "STACK=$1" "OUT=$2" "PIECES=$3" \
    "PLAN_OPTIONS=${*:4}"
}
with_mpi() { # more ranks than cores, and as root in containers
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 PROGRAM="${FAULTY:-} $PROGRAM" \
    MPIRUN="mpirun --oversubscribe -q" RANKS=3 "$engines/mpi.sh" "$@"
}
with_slurm() { "$engines/slurm/submit" "$@"; }
with_snakemake() {
  (cd "$(dirname "$2")" && snakemake -q -s "$engines/Snakefile" -j2 --nolock \
    --config "stack=$1" "out=$2" "pieces='$3'" "plan_options=${*:4}")
}
