%
o9116 (round the top edge of a boss with an end mill)
(g65 p9116 x_ y_ u_ v_ r_ z_ i_ c_ d_ f_)
(x y  centre of the boss      u v  its length along x and y)
(r    top face                i    radius of the rounding)
(z    clearance plane         c    steps, 20 when left out)
(d    offset of the radius    f    feed)
if [#24 eq #0] then #3000 = 61 (x missing)
if [#25 eq #0] then #3000 = 61 (y missing)
if [#18 eq #0] then #3000 = 62 (r missing)
if [#26 le #18] then #3000 = 63 (z is not above r)
if [#21 le 0] then #3000 = 64 (length u)
if [#22 le 0] then #3000 = 64 (length v)
if [#4 le 0] then #3000 = 65 (radius i)
if [#7 lt 1] then #3000 = 66 (offset d)
if [#7 gt 200] then #3000 = 66 (offset d)
if [#9 le 0] then #3000 = 67 (feed f)
if [#3 eq #0] then #3 = 20
if [#3 lt 4] then #3 = 4

#30 = #4001
#31 = #4003
#33 = #4109
#27 = #[12000 + #7] + #[13000 + #7]

g90 g0 x[#24 + #21 / 2 + #27 + 2.] y[#25 - #22 / 2 - #27 - 2.]
z#26
#10 = 0
while [#10 le #3] do 1
  #28 = 90 - 90 * #10 / #3 (angle, 90 is the flank, 0 the top)
  #29 = #4 * [1 - cos[90 - #28]] (inset from the flank)
  #32 = #18 - #4 * [1 - cos[#28]] (height of this step)
  #12 = #21 / 2 + #27 - #29
  #13 = #22 / 2 + #27 - #29
  g1 z#32 f#9
  x[#24 + #12] y[#25 - #13]
  y[#25 + #13]
  x[#24 - #12]
  y[#25 - #13]
  x[#24 + #12]
  #10 = #10 + 1
end 1
g0 z#26
g#30 g#31 f#33
m99
%
