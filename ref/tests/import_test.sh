#!/bin/bash
# flatdt import on small files written by hand: every rule and every refusal.
# Usage: import_test.sh FLATDT
set -u
flatdt=$(realpath "$1")
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir" || exit 1
failures=0

fail() {
  echo "FAILED $1" >&2
  failures=$((failures + 1))
}

# accept FILE TEXT... -- OPTIONS: the instance (or a message) must have each TEXT on a line.
accept() {
  local file=$1 texts=() text
  shift
  while [ $# -gt 0 ] && [ "$1" != -- ]; do texts+=("$1"); shift; done
  [ $# -gt 0 ] && shift
  "$flatdt" import "$file" "$@" -o out.instance 2>err || fail "$file: refused: $(cat err)"
  for text in "${texts[@]}"; do
    grep -qF -e "$text" out.instance || fail "$file: no \"$text\" in: $(head -30 out.instance)"
  done
  "$flatdt" info out.instance >/dev/null 2>err || fail "$file: the instance is not admissible: $(cat err)"
  rm -f out.instance
}

# refuse FILE TEXT OPTIONS: exit code 2, TEXT in the message, nothing written.
refuse() {
  local file=$1 text=$2
  shift 2
  "$flatdt" import "$file" "$@" -o out.instance 2>err
  local code=$?
  [ $code = 2 ] || fail "$file: exit code $code, not 2: $(cat err)"
  grep -qF -e "$text" err || fail "$file: no \"$text\" in: $(cat err)"
  grep -qF -e "$file" err || fail "$file: the message does not name the file: $(cat err)"
  [ ! -e out.instance ] || fail "$file: something was written"
}

# cif NAME CELL SYMBOL OPERATIONS [SITES]: CELL is six numbers, OPERATIONS are separated by blanks, SITES by
# semicolons; empty: absent.
cif() {
  local sites=${5-"C1 0.1 0.2 0.3;C2 0.45 0.05 0.61"}
  {
    echo "# written by hand"
    echo "data_test"
    local names=(length_a length_b length_c angle_alpha angle_beta angle_gamma) i=0 value
    for value in $2; do echo "_cell_${names[$i]} $value"; i=$((i + 1)); done
    [ -n "$3" ] && echo "_symmetry_space_group_name_H-M '$3'"
    if [ -n "$4" ]; then
      printf 'loop_\n_symmetry_equiv_pos_as_xyz\n'
      printf "'%s'\n" $4
    fi
    printf 'loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n'
    tr ';' '\n' <<<"$sites"
  } >"$1"
}

# refuse_cif TEXT CELL SYMBOL OPERATIONS [SITES]
refuse_cif() {
  local text=$1
  shift
  cif case.cif "$@"
  refuse case.cif "$text"
}

# --- Numbers: exact decimals, uncertainties stripped, nothing snapped.
refuse_cif '"1/2" is not a number' "5.00(2) 6 7.5 90 90.00(3) 90" "P 1" "" "C1 0.3333 -0.25(3) 1.5e-1;C2 .5 1/2 0"
cif p1.cif "5.00(2) 6 7.5 90 90.00(3) 90" "P 1" "" "C1 0.3333 -0.25(3) 1.5e-1;C2 .5 +2. 0"
accept p1.cif "manifold torocosm" "metric 25 0 0 36 0 225/4" "3333/10000 -1/4 3/20  # C1" "1/2 2 0  # C2" "points 2"
"$flatdt" import - <p1.cif >out 2>err && grep -q '^points 2' out || fail "standard input"
cif oblique.cif "4 5 6 60 80 120" "P 1" ""
# b c cos 60 = 15 and a b cos 120 = -10 exactly; a c cos 80 = 24 * 0.17364817766693 = 4.167556264...
accept oblique.cif "metric 16 -10 1041889/250000 25 15 36"

# --- Groups from symbols: short ones, other settings, centring.
cif p21.cif "5 6 7 90 100.5 90" "P21" ""
accept p21.cif "manifold dicosm" "-1 0 0 0 0 1 0 1/2 0 0 -1 0" "group P21 (P 1 21 1)"
cif pc.cif "5 6 7 90 100.5 90" "Pc" ""
accept pc.cif "manifold first-amphicosm"
cif cc.cif "5 6 7 90 100.5 90" "Cc" ""
accept cc.cif "manifold second-amphicosm" "1 0 0 1/2 0 1 0 1/2 0 0 1 0"
cif p21cn.cif "5 6 7 90 90 90" "P 21 c n" ""
accept p21cn.cif "manifold second-amphidicosm"
cif spelling.cif "5 6 7 90 90 90" "P2(1)2(1)2(1)" ""
accept spelling.cif "manifold didicosm"

# --- Groups from operations.
hexagonal="6.5 6.5 9 90 90 120"
cif p31.cif "$hexagonal" "P 31" "x,y,z -y,x-y,z+0.3333 Y-X,-X,.6667+Z"
accept p31.cif "manifold tricosm" "metric 169/4 -169/8 0 169/4 0 81" "0 -1 0 0 1 -1 0 0 0 0 1 1/3"
cif p65.cif "$hexagonal" "" "x-y,x,z+5/6"
accept p65.cif "manifold hexacosm" "generators 8"
cif origin.cif "5 6 7 90 90 90" "P 21 21 21" "x,y,z x+1/2,-y,-z+1/4 -x+1/2,y+1/2,-z+3/4 -x,-y+1/2,z+1/2"
accept origin.cif "manifold didicosm"
cif unique_c.cif "5 6 7 90 90 95" "P21" "x,y,z -x,-y,z+1/2"
accept unique_c.cif "manifold dicosm"
refuse_cif "contradict the symbol" "5 6 7 90 90 95" "P 1 21 1" "x,y,z -x,-y,z+1/2"
cif uncentred.cif "5 6 7 90 100 90" "Cc" "x,y,z x,-y,z+1/2"
accept uncentred.cif "manifold second-amphicosm" "lack the centring translations"
cif odd.cif "5 6 7 90 90 90" "P 17 quux" "x,y,z -x,-y,z+1/2"
accept odd.cif "manifold dicosm" "is unknown: the listed operations count"
refuse_cif 'contradict the symbol "P21"' "5 6 7 90 90 90" "P21" "x,y,z x,-y,z+1/2"
refuse_cif 'symbol "P 17 quux" is unknown' "5 6 7 90 90 90" "P 17 quux" ""
refuse_cif "neither symmetry operations nor a group symbol" "5 6 7 90 90 90" "" ""
for bad in "x,y" "x,y,z,x" "x,y,q" "x,y," "2x,y,z" "x,x,z" "x+1/0,y,z" "x+0.29,y,z" "x+-,y,z"; do
  refuse_cif "symmetry operation" "5 6 7 90 90 90" "" "x,y,z $bad"
done
refuse_cif "do not generate a space group" "5 6 7 90 90 90" "" "x+y,y,z"

# --- Groups that are not torsion-free, cells that contradict the group.
for symbol in "P -1" "P 1 2 1" "C 1 2 1" "P n m a" "P m" "I a -3 d"; do
  refuse_cif "fixed point" "6 6 6 90 90 90" "$symbol" ""
done
refuse_cif "contradicts the group P 31" "14.231 14.227 10.24 90.07 90.15 120.04" "P 31" ""
refuse_cif "contradicts the group P21" "5 6 7 90.01 100 90" "P21" ""
refuse_cif "contradicts the group P 61" "5 5 7 90 90 90" "P 61" ""
# A primitive cell of Cc: the face diagonals are equal, their angles to c too, rounding included.
cif primitive.cif "5.1 5.1 7 97.3 97.3 101.7" "" "x,y,z y,x,z+1/2"
accept primitive.cif "manifold second-amphicosm"

# --- Cells.
for cell in "0 6 7 90 90 90" "-5 6 7 90 90 90" "1e9 6 7 90 90 90"; do
  refuse_cif "cell parameter a" "$cell" "P 1" ""
done
refuse_cif "cell parameter alpha" "5 6 7 0 90 90" "P 1" ""
refuse_cif "cell parameter beta" "5 6 7 90 180 90" "P 1" ""
refuse_cif "no cell has the angles" "5 6 7 60 60 120" "P 1" ""
refuse_cif "no cell has the angles" "5 6 7 20 30 120" "P 1" ""
# Flat, one angle the sum of the others or all 360 together, though a rounded metric may be positive definite.
refuse_cif "no cell has the angles" "10 11 12 40 100 60" "P 1" ""
refuse_cif "no cell has the angles" "10 11 12 100 140 120" "P 1" ""
refuse_cif "no unit cell" "? 6 7 90 90 90" "P 1" ""
refuse_cif "no unit cell" "5" "P 1" ""
refuse_cif '"five" is not a number' "five 6 7 90 90 90" "P 1" ""

# --- Sites: coincident, alternative, without coordinates, none.
refuse_cif "Al with Fe" "5 6 7 90 100 90" "P21" "" "Fe 0.1 0.2 0.3;Al -0.1 1.7 0.7;O 0 0 0"
accept case.cif "points 2" "1/10 1/5 3/10  # Fe" "coincident sites merged: Al with Fe" -- --coincident merge
cif holes.cif "5 6 7 90 100 90" "P21" "" "C1 0.1 0.2 0.3;H1 ? ? ?;H2 . . ."
accept holes.cif "points 1" "2 sites without coordinates"
refuse_cif "no atom sites with coordinates" "5 6 7 90 100 90" "P21" "" "H1 ? ? ?"
cat >disorder.cif <<'CIF'
data_x _cell_length_a 5 _cell_length_b 6 _cell_length_c 7
_cell_angle_alpha 90 _cell_angle_beta 90 _cell_angle_gamma 90 _space_group_name_H-M_alt 'P 1'
loop_ _atom_site_label _atom_site_disorder_assembly _atom_site_disorder_group
_atom_site_fract_x _atom_site_fract_y _atom_site_fract_z
C1 . . 0.1 0.1 0.1
C2 A 2 0.2 0.2 0.2
C3 A 1 0.3 0.3 0.3
C4 B 1 0.4 0.4 0.4
C5 B 2 0.5 0.5 0.5
CIF
accept disorder.cif "points 3" "# C2" "# C4" "4 sites, 2 of later labels left out"
accept disorder.cif "points 5" "4 sites, all kept" -- --altloc all

# --- PDB.
pdb_atom() { # NAME ALTLOC RESIDUE-NUMBER X Y Z
  printf 'ATOM      1  %-3s%1s%3s A%4s    %8s%8s%8s  1.00 10.00           C  \n' "$1" "$2" GLY "$3" "$4" "$5" "$6"
}
p21_cell="CRYST1   10.000   20.000   30.000  90.00  90.00  90.00 P 1 21 1      2"
{
  echo "HEADER    TEST"
  echo "REMARK 290       1555   X,Y,Z"
  echo "REMARK 290       2555   -X,Y+1/2,-Z"
  echo "$p21_cell"
  echo "SCALE1      0.100000  0.000000  0.000000        0.00000"
  echo "SCALE2      0.000000  0.050000  0.000000        0.00000"
  echo "SCALE3      0.000000  0.000000  0.033333        0.50000"
  echo "MODEL        1"
  pdb_atom N "" 1 1.000 2.000 3.000
  pdb_atom CA B 1 2.000 2.000 3.000
  pdb_atom CA A 1 2.500 2.000 3.000
  pdb_atom CA A 2 4.000 2.000 3.000
  echo "ENDMDL"
  echo "MODEL        2"
  pdb_atom N "" 1 9.000 2.000 3.000
  echo "ENDMDL"
} >a.pdb
accept a.pdb "manifold dicosm" "points 3" "1/10 1/10 599999/1000000  # N GLY A1" "# CA.B GLY A1" "# CA.A GLY A2" \
  "1 atoms of later ones are left out" "by the matrix of the file"
accept a.pdb "points 4" -- --altloc all
sed 's/$/\r/' a.pdb >crlf.pdb
accept crlf.pdb "points 3"
grep -v SCALE a.pdb >unscaled.pdb
accept unscaled.pdb "1/10 1/10 1/10  # N GLY A1" "by the matrix of the cell"
# A flat cell whose metric is positive definite by rounding; the square root of its volume's square crashed.
flat_cell="CRYST1   10.000   11.000   12.000  40.00 100.00  60.00 P 1                   "
{ echo "$flat_cell"; pdb_atom N "" 1 1.000 2.000 3.000; } >flat.pdb
refuse flat.pdb "no cell has the angles"
sed 's/0.050000/0.500000/' a.pdb >scale.pdb
refuse scale.pdb "does not fit the cell"
grep -v CRYST1 a.pdb >uncelled.pdb
refuse uncelled.pdb "no unit cell"
sed 's/^CRYST1.*/CRYST1    1.000    1.000    1.000  90.00  90.00  90.00 P 1           1/; /SCALE/d; /REMARK/d' a.pdb >nmr.pdb
refuse nmr.pdb "placeholder"
sed 's/Y+1\/2/Y/' a.pdb >operations.pdb
refuse operations.pdb "contradict the symbol"
grep -v ATOM a.pdb >no_atoms.pdb
refuse no_atoms.pdb "no atom sites"
cut -c1-50 a.pdb >short.pdb
refuse short.pdb "short.pdb:"
sed 's/   4.000/   4.0x0/' a.pdb >letters.pdb
refuse letters.pdb 'letters.pdb:12: coordinate: "4.0x0" is not a number'
{ echo "CRYST1   63.400   63.400   83.800  90.00  90.00 120.00 P 61         12  1HPV 179"
  echo "ATOM      1  N   PRO A   1      13.120  39.003   5.159  1.00 55.41      1HPV 186"; } >old.pdb
accept old.pdb "manifold hexacosm" "points 1" # the matrix of a hexagonal cell has irrational entries

# --- mmCIF.
mmcif() {
  printf 'data_X\n'
  printf '_cell.%s\n' 'length_a 10' 'length_b 20' 'length_c 30' 'angle_alpha 90' 'angle_beta 90' 'angle_gamma 90'
  echo "_symmetry.space_group_name_H-M 'P 21 21 21'"
  printf 'loop_\n'
  printf '_atom_site.%s\n' label_atom_id label_alt_id label_comp_id label_asym_id auth_asym_id auth_seq_id \
    Cartn_x Cartn_y Cartn_z pdbx_PDB_model_num
  printf 'N . GLY A A 1 1.000 2.000 3.000 1\nCA A GLY A A 1 2.000 2.000 3.000 1\nCA B GLY A A 1 3.000 2.000 3.000 1\n'
  printf 'N . GLY A A 1 4.000 2.000 3.000 2\n'
}
mmcif >m.cif
accept m.cif "manifold didicosm" "points 2" "1/10 1/10 1/10  # N GLY A1" "1/5 1/10 1/10  # CA.A GLY A1" "later ones are left out"
accept m.cif "points 3" -- --altloc all
sed 's/3.000 1$/? 1/' m.cif >holes_m.cif
refuse holes_m.cif "has no coordinates"

# --- Damaged files.
gzip -c p21.cif >p21.cif.gz
accept p21.cif.gz "manifold dicosm"
cat p21.cif.gz p21.cif.gz | head -c 200 >cut.cif.gz
refuse cut.cif.gz "damaged or cut short"
: >empty.cif
refuse empty.cif "neither CIF"
head -c 4096 /dev/zero >binary.cif
refuse binary.cif "neither CIF"
head -c 3000 "$flatdt" >program.pdb
refuse program.pdb "neither CIF"
echo "once upon a time" >prose.cif
refuse prose.cif "neither CIF"
echo "data_" >only.cif
refuse only.cif "no atom sites"
head -n -1 p21.cif | head -c -5 >cut.cif
refuse cut.cif "cut.cif"
printf 'data_x\n_cell_length_a "5\n' >quote.cif
refuse quote.cif "quote.cif"
printf 'data_x\nloop_\n_atom_site_fract_x\n_atom_site_fract_y\n1 2 3\n' >loop.cif
refuse loop.cif "loop.cif"
refuse missing.cif "cannot be read"
size=$(wc -c <p21.cif)
for ((n = 0; n < size; n += 7)); do
  head -c "$n" p21.cif | "$flatdt" import - >out 2>err
  code=${PIPESTATUS[1]}
  [ "$code" = 2 ] || [ "$code" = 0 ] || fail "the first $n bytes of p21.cif: exit code $code"
done

echo "$failures failures"
[ $failures = 0 ]
