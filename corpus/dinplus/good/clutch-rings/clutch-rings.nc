%clutch-rings.nc
[Clutch rings, family of four sizes. The size is asked for; teeth are
 milled by CR_TEETH, the ring is measured by CR_CHECK and the shift book
 is written by CR_BOOK. Local subprogram "CLEAN" blows the jaws clean.]
PROGRAM HEAD
#UNIT METRIC
#MATERIAL 16MnCr5
#DRAWING CR-1 TO CR-4
TURRET 1
T1 ID"ROUGH 80"
T2 ID"FINISH 55"
T9 ID"END MILL 8"
T12 ID"PROBE"
CONST
_sd=2
_half_turn=180
_vc_rough=170
_vc_fine=_vc_rough*1.3
VAR
#_size=#l1
#_d_out=#l2
#_d_in=#l3
#_teeth=#l4
#_good=#g205
#_scrap=#g206
MACHINING
N10 G26 S2400
N11 G126 S4500
N12 G59 Z150
N13 WINDOW(8,"CLUTCH")
N14 #x1=TIME("D.M.YY")
N15 #_size=0
N16 WHILE (#_size<1) OR (#_size>4)
N17 INPUT("Size 1 to 4",#_size)
N18 ENDWHILE
N19 SWITCH #_size
N20 CASE 1
N21 #_d_out=60
N22 #_d_in=32
N23 #_teeth=6
N24 BREAK
N25 CASE 2
N26 #_d_out=80
N27 #_d_in=45
N28 #_teeth=8
N29 BREAK
N30 CASE 3
N31 #_d_out=100
N32 #_d_in=60
N33 #_teeth=10
N34 BREAK
N35 DEFAULT
N36 #_d_out=125
N37 #_d_in=80
N38 #_teeth=12
N39 BREAK
N40 ENDSWITCH
N41 L"CLEAN" Q2
N42 G14 Q0
[Turn: contour given directly behind the cycle]
N43 T1
N44 G96 S_vc_rough G95 F0.3 M4
N45 G0 X#_d_out+10 Z_sd M8
N46 G810 P2 I0.3 K0.1 H0 Q0 RH4 XA2 ZA1.5
N47 G0 X#_d_out-4 Z0
N48 G1 X#_d_out Z-2
N49 G1 Z-20
N50 G80
N51 G14 Q0
N52 T2
N53 G96 S_vc_fine G95 F0.12 M4
N54 G0 X#_d_out-4 Z_sd
N55 G890 H3
N56 G0 X#_d_out-4 Z0
N57 G1 X#_d_out Z-2
N58 G1 Z-20
N59 G80
N60 G14 Q0 M9
[Teeth]
N61 M5
N62 T9
N63 G197 S2400 G193 F0.03 M103
N64 M14
N65 L"CR_TEETH" V1 LA#_d_out LB#_d_in LC#_teeth LD4 LH1 WC_half_turn
N66 #l5=#i99
N67 M15
N68 M105
N69 G14 Q0
N70 IF #l5<>#_teeth
N71 THEN
N72 PRINT("Only ",#l5," teeth were milled")
N73 M0
N74 ENDIF
[Measure and book]
N75 T12
N76 L"CR_CHECK" V1 LA#_d_out LB-10 LI0.02 LK903
N77 #x2=#i99
N78 IF #x2=="GOOD"
N79 THEN
N80 #_good=#_good+1
N81 ELSE
N82 #_scrap=#_scrap+1
N83 ENDIF
N84 L"CR_BOOK" V1 LA#_good LB#_scrap ID"CLUTCH RINGS" AT#x1
N85 G14 Q0
N86 WINDOW(0)
N87 M30
SUBPROGRAM "CLEAN"
N90 M120 [air on]
N91 G4 F1.5
N92 M121 [air off]
N93 G4 F0.5
RETURN
END
