%monday-check.nc
[Monday morning: warm-up and check of the machine without a workpiece.
 Compares the axes, runs the maker's tests once, logs what was read.
 Nothing is clamped; doors closed, chuck jaws in.]
PROGRAM HEAD
#UNIT METRIC
#MACHINE LATHE 3
TURRET 1
T1 ID"FACING 80"
MACHINING
N10 G26 S2000
N11 G48 F5000 D1
N12 G48 F5000 D3 A60
N13 WINDOW(10,"MONDAY")
N14 #x1=TIME("D.M.YY")+" "+TIME("h:m:s")
N15 PRINT("Check of lathe 3, ",#x1)
[Spindle through its ranges, swinging speed]
N16 G53
N17 G14 Q0
N18 T1
N19 G999 Q1
N20 G97 S300 M3
N21 G4 F30
N22 G919 Q0 H1
N23 G924 Q0 K0.5 I100 H1
N24 G97 S1200
N25 G4 F60
N26 G924 Q0 H0
N27 G919 Q0 H0
N28 M5
N29 G999 Q0
[Axes, feed at 100 per cent in the measuring moves]
N30 G0 X300 Z200
N31 G94 F1000
N32 G908 H0 G1 X200
N33 G908 H1 G1 Z100
N34 G908 H2 G1 X300
[Actual values, zero shifts and lag into the log]
N35 G901
N36 G909
N37 #l1=#a1(X,1)
N38 #l2=#a1(Z,1)
N39 G902
N40 G909
N41 #l3=#a0(Z,1)
N42 G903
N43 G909
N44 #l4=#a3(Z,1)
N45 G904
N46 G909
N47 #l5=#a2(Z,1)
N48 PRINT("X ",#l1," Z ",#l2," shift ",#l3," lag ",#l4," target ",#l5)
[Machine coordinates: without shifts, then without tool lengths]
N49 G920
N50 G701 X400 Z600
N51 G980
N52 G921
N53 G701 X420 Z620
N54 G981
[Force limits, tailstock quill on W: 200 daN for the probe run]
N55 G925 H200 Q3 P1
N56 G94 F500
N57 G1 Z150
N58 G925 H200 Q3 P0
N59 G0 Z200
N60 G930 H150 Q6 K-20
N61 G4 F2
[Load monitoring of one air cut, zone 1]
N62 G996 Q1 H1
N63 G995 H1 ID"XZ0"
N64 G95 F0.3 G97 S800 M3
N65 G1 Z120
N66 G1 X280
N67 G0 Z200
N68 G995
N69 G996 Q0
N70 M5
[Component test and fingerprint: dry run first, then the measurement]
N71 G939 ID"SPINDLE_1"
N72 G0 X400 Z500
N73 G238 H1 Q1 D1
N74 G238 H0 Q1 D1
N75 G238 H1 Q2 V9
N76 G238 H0 Q2 V9
[Taper of the bed put right, lift-off at NC stop for the first part]
N77 G976 Z0 K-400 I0.01 J0 H1
N78 G977 H1 A45 W0 R2
N79 G97 S800 M3
N80 G95 F0.3
N81 G0 X200 Z5
N82 G64 E0.1 F1
N83 G1 Z-100
N84 G64
N85 G0 X220
N86 G0 Z5
N87 G977 H0
N88 G976 H0
N89 M5
N90 G941 ID"MONDAY CHECK DONE %.1f" R#l4
N91 G48
N92 G55
N93 G14 Q0
N94 WINDOW(0)
N95 M30
END
