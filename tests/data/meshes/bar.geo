// One element across, two along: every element type by the same steps.
Point(1) = {0, 0, 0, 9}; Point(2) = {1, 0, 0, 9}; Point(3) = {1, 1, 0, 9}; Point(4) = {0, 1, 0, 9};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1:4} = 2; Transfinite Surface {1};
If (HEX == 1)
  Recombine Surface {1};
EndIf
If (WEDGE + HEX > 0)
  v[] = Extrude {0, 0, 2} { Surface{1}; Layers{2}; Recombine; };
Else
  v[] = Extrude {0, 0, 2} { Surface{1}; Layers{2}; };
EndIf
Physical Volume("bar", 11) = {v[1]};
Physical Surface("low_end", 12) = {1};
Physical Surface("High_End", 13) = {v[0]};
Physical Point("origin") = {1};
