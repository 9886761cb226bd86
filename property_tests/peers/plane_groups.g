# The table of plane_groups_test.cpp against GAP: each of our 17 groups is conjugate to the one of its number.
# Run: gap -q property_tests/peers/plane_groups.g     (Debian packages gap-core gap-cryst gap-crystcat gap-polycyclic)
# Prints 17 lines that end in "true".
LoadPackage("cryst");; LoadPackage("crystcat");; LoadPackage("polycyclic");;
h:=1/2;;
A:=function(a,b,t,c,d,u) return [[a,b,t],[c,d,u],[0,0,1]]; end;;
ht:=A(-1,0,0,0,-1,0);; mx:=A(-1,0,0,0,1,0);; ce:=A(1,0,h,0,1,h);; t3:=A(0,-1,0,1,-1,0);; t4:=A(0,-1,0,1,0,0);; t6:=A(1,-1,0,1,0,0);; sw:=A(0,1,0,1,0,0);;
tr:=[A(1,0,1,0,1,0),A(1,0,0,0,1,1)];;
L:=[["p1",[]],["p2",[ht]],["pm",[mx]],["pg",[A(-1,0,0,0,1,h)]],["cm",[mx,ce]],["p2mm",[ht,mx]],["p2mg",[ht,A(-1,0,h,0,1,0)]],["p2gg",[ht,A(-1,0,h,0,1,h)]],["c2mm",[ht,mx,ce]],["p4",[t4]],["p4mm",[t4,mx]],["p4gm",[t4,A(-1,0,h,0,1,h)]],["p3",[t3]],["p3m1",[t3,A(0,-1,0,-1,0,0)]],["p31m",[t3,sw]],["p6",[t6]],["p6mm",[t6,sw]]];;
for i in [1..17] do
 S:=AffineCrystGroupOnLeft(Concatenation(tr,L[i][2]));
 T:=SpaceGroupOnLeftIT(2,i);
 c:=ConjugatorSpaceGroups(S,T);
 Print(L[i][1]," no. ",i," ",c<>fail,"\n");
od;
QUIT;
