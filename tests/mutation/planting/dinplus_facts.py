"""Words of the codes of DIN PLUS that our clean programs use, as the manual lists them: one row a code.

m: in MACHINING and subprograms, c: in sections with contours. P!: the manual says, or the code cannot work otherwise, that the
word must be there. H=0,1 and NF=1..127: what whole numbers it takes.
"""

ROWS = '''
G0 c X Z PZ W
G0 m X Z Y B W U V
G1 c X Z AN Q=0,1 BR PZ W AR R FP=1,2,3 IC KC HC BE BF BD=900..916 BP BH=0,1 A
G1 m X Z Y AN Q=0,1 BR BE A B E
G2 c X Z R I K Q=0,1 BR FP=1,2,3 BE BF BD=900..916 BP BH=0,1
G2 m X Z Y R I K J Q=0,1 BR BE B E
G3 c X Z R I K Q=0,1 BR FP=1,2,3 BE BF BD=900..916 BP BH=0,1
G3 m X Z Y R I K J Q=0,1 BR BE B E
G4 m F D
G7 m
G8 m
G9 m
G10 c H=1,2,3 RH
G12 c X Z I K R Q=0,1 BR PZ W PM WM AR AN FP=1,2,3 BE BF BD=900..916 BP BH=0,1
G12 m X Z Y R I K J Q=0,1 BR BE E B
G13 c X Z I K R Q=0,1 BR PZ W PM WM AR AN FP=1,2,3 BE BF BD=900..916 BP BH=0,1
G13 m X Z Y R I K J Q=0,1 BR BE E B
G14 m Q D=0,1,2
G16 m B I K U W Q=0,1,2
G17 m
G18 m
G19 m
G20 c X! Z! K I
G21 c P Q=0,1
G22 c X Z I Ii K Ki B R FP=1 BE BF BD=900..916 BP BH=0,1
G23 c H=0,1 X Z I K U A B P R FP=1 BE BF BD=900..916 BP BH=0,1
G24 c F I K Z! FP=1 BE BF BD=900..916 BP BH=0,1
G25 c H=0,4,5,6,7,8,9 I K R P W A FP BE BF BD=900..916 BP BH=0,1
G25 m H=0,5,6,7 I K R P W A FP U E
G26 m S!
G30 m H Q
G31 m ID NS NE O=0,1,2,3,4 J=0,1 I IC B P A V=0,1,2,3,4,5,6 H=0,1,2,3 R C BD=0,1 F U K D Q E
G32 m X Z XS ZS BD=0,1 F! U I IC V=0,1,2,3,4,5,6 H=0,1,2,3 WE=0,1 K W C A R=0,1 E Q D J=0,1
G33 m X Z F B P C H=0,1,3 E I K
G34 c F
G35 m X Z! F I Q V=0,1,2,3,4,5,6
G36 m X Z F! B S P I
G37 c Q=1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20 F P K D=0,1 H A W R E V=0,1
G38 c E
G38 m ID! NS NE HID RH=0,1 Q=0,1 X Z H XE ZE F! I K J C O=0,1
G39 c F V=1,2,3 RH D=901..916 P H=0,1 E
G40 m
G41 m Q=0,1,2,3,4 H=0,1 O=0,1
G42 m Q=0,1,2,3,4 H=0,1 O=0,1
G44 c D=0,1
G47 m P
G48 m F D=1,2,3,4,5,6,7,8,9 A
G49 c Z B! P! W R U E I J K F V=0,1 A=0,180 O
G50 m
G51 m X Y Z U V W
G52 c P H=0,1
G52 m
G53 m
G54 m
G55 m
G56 m X Y Z U V W
G57 m X Z
G58 m P!
G59 m X Y Z U V W
G60 m Q=0,1
G62 m H=0..15 Q=1..3 O=-1,0,1 X Z Y
G63 m
G64 m E F
G65 m H=0 D=0 X Z Q=4,5 B P V
G67 m ID NS
G71 m ID NS NF XS ZS XE ZE K A V=0,1,2,3 RB E D=0,1 BS BE H=0,1 Z X
G72 m ID NS RB E D=0,1 BS BE H=0,1
G73 m ID NS XS ZS XE ZE K F B S J RB P I BS BE H=0,1
G74 m ID NS XS ZS XE ZE K P I B J R A V=0,1,2,3 RB E D=0,1 BS BE H=0,1 Z
G75 m ID NS O=0,1,2,3 B P U H=0,1 I K F RB W WB
G80 m XS ZS XE ZE AC WC BS WS BE WE RC IC KC JC=0,1 EC=0,1 HC=0,1
G81 m X Z I K Q=0,1 V=0,1 H=0,2
G82 m X Z I K Q=0,1 V=0,1 H=0,2
G83 m X Z I K
G85 m X Z I K E
G86 m X Z I K E
G87 m X Z B! E
G88 m X Z B! E
G94 m F
G95 c F
G95 m F
G96 m S
G97 m S
G99 m Q=1..4 D X Z V=0,1 H=0,1 K O=0..7
G100 c X C XK YK
G100 m X C XK YK Z
G101 c X C XK YK AN Q=0,1 BR AR R
G101 m X C XK YK Z AN BR Q=0,1
G102 c X C XK YK R I J Q=0,1 BR XM CM AR AN
G102 m X C XK YK R I J K Z H=0,1,2,3 AN BR Q=0,1
G103 c X C XK YK R I J Q=0,1 BR XM CM AR AN
G103 m X C XK YK R I J K Z H=0,1,2,3 AN BR Q=0,1
G110 c Z C CY PZ
G110 m Z C CY X
G111 c Z C CY AN Q=0,1 BR PZ AR R
G111 m Z C CY X AN BR Q=0,1
G112 c Z C CY R K J Q=0,1 BR PZ W PM AR AN
G112 m Z C CY R K J W X AN BR Q=0,1
G113 c Z C CY R K J Q=0,1 BR PZ W PM AR AN
G113 m Z C CY R K J W X AN BR Q=0,1
G120 m X!
G126 m S!
G140 m D!=1,2 X Z Y
G147 m I K
G148 m O=0,1,2
G149 c D=900..916
G149 m D=900,901,902,903,904,905,906,907,908,909,910,911,912,913,914,915,916
G150 m
G151 m
G152 m C!
G153 m
G154 m H!=0,1
G162 m H!=0..15
G170 c X Y PZ W
G171 c X Y AN Q=0,1 BR PZ W AR R
G172 c X Y R I J Q=0,1 BR PZ W PM WM AR AN
G173 c X Y R I J Q=0,1 BR PZ W PM WM AR AN
G180 c Y Z PZ W
G181 c Y Z AN Q=0,1 BR PZ W AR R
G182 c Y Z R J K Q=0,1 BR PZ W PM WM AR AN
G183 c Y Z R J K Q=0,1 BR PZ W PM WM AR AN
G193 m F
G195 m F
G197 m S
G238 m H=0,1 Q=0,1,2,3,4 D=1..9 V=1..9
G300 c XK YK B P W R U E I J K F V=0,1 A O
G301 c XK YK X C A K! B! P
G301 m XK YK X C A K! B! P
G302 c I J X C R! A W B! P
G302 m I J X C R A W B! P
G303 c I J X C R! A W B! P
G303 m I J X C R A W B! P
G304 c XK YK X C R! P
G304 m XK YK X C R! P
G305 c XK YK X C A K! B! R P
G305 m XK YK X C A K! B! R P
G306 c X C XK YK ID NF  P W H E V=0,1,2 D F O=0,1
G307 c XK YK X C A Q! K! R P
G307 m XK YK X C A Q! K! R P
G308 c ID P HC=1,2,3,4,5,6,7,8,9,10,11,12,14 D Q=0,1,2 H=0,1 O=0,1,2 I RC RB W BR
G309 c
G310 c Z CY C B! P W R U E I J K F V=0,1 A O
G311 c Z CY C A K! B! P
G311 m Z! CY C A K! B! P
G312 c Z CY C R! A W B! P
G312 m Z! CY C R! A W B! P
G313 c Z CY C R! A W B! P
G313 m Z! CY C R! A W B! P
G314 c Z CY C R! P
G314 m Z! CY C R! P
G315 c Z CY C A K! B! R P
G315 m Z! CY C A K! B! R P
G316 c Z C CY ID NF  P W H E F O=0,1
G317 c Z CY C Q! A K! R P
G317 m Z! CY C Q! A K! R P
G326 m S!
G350 m Z! F! U! I
G351 m Z! F! U! I A D J E
G352 m X Z! XS ZS! F U! I V=0,1,2,3,4,5,6 H=0,1,2,3 A R W WE D Q C
G370 c X Y B P W R U E I J K F V=0,1 A O
G371 c X Y A K! B! P I
G372 c X Y R! A W B! P I
G373 c X Y R! A W B! P I
G374 c X Y R! P I
G375 c X Y A K! B! R P I
G376 c Z K Ki B! I C
G377 c X Y Q! A K! R P I
G378 c X Y ID NF P W H E F O=0,1
G380 c Y Z B P W R U E I J K F V=0,1 A O
G381 c Z Y X A K! B! P
G382 c Z Y X R! A W B! P
G383 c Z Y X R! A W B! P
G384 c Z Y X R! P
G385 c Z Y X A K! B! R P
G386 c Z K Ki B X C
G387 c Z Y X Q! A K! R P
G388 c Y Z ID NF P W H E F O=0,1
G395 m F
G396 m S
G401 c Q! XK YK I Ii J Ji A R Ri
G402 c Q K A W Wi V=0,1,2 XK YK H=0,1
G405 c ID! XK YK A R Ri
G411 c Q! Z C CY ZE ZEi W Wi A R Ri
G412 c Q! K! A W Wi V=0,1,2 Z C H=0,1
G415 c ID! Z C CY A R Ri
G471 c Q! X Y I J Ii Ji A R Ri
G472 c Q! K! A W Wi V=0,1,2 X Y H=0,1
G475 c ID! X Y A R Ri
G477 c Z K Ki B! C Q! I
G481 c Q! Z Y K J Ki Ji A R Ri
G482 c Q! K! A W Wi V=0,1,2 Z Y H=0,1
G485 c ID! Z Y A R Ri
G487 c Z K Ki B! X C Q!
G701 m X Z Y B
G702 m ID Q!=0,1,2 H=0..9 V=0,1,2
G703 m Q!=0,1
G720 m S H C Q F Y
G725 m H!=0,1 Q R C F V=0,1
G726 m H!=0,1 Q R C F V=0,1 Z K W U
G727 m H!=0,1 Q I C F E Z W
G728 m H!=0,1 Q D O WC Z J
G740 m X Z I K Q!
G741 m X Z I Ii K Ki Q! A R Ri O=0,1
G743 m XK YK ZS ZE X C A I Ii J Ji R Ri Q! Ai
G744 m XS Z! XE ZE C! W Wi Q! A R Ri
G745 m XK YK ZS ZE X C K! A W Wi Q! V=0,1,2 Z
G746 m Z! C! XS XE K! A W Wi Q! V=0,1,2
G747 m R=0,1,2 D K AC BD WE F Q P H AN
G748 m K RB RC AC EC BE WE F Q P H AN
G764 m D K V O F Q P H
G765 m C V O F Q P H AC BD
G766 m Z X NF V O F Q P H AC BD
G767 m XK YK NF V O F Q P H
G768 m Z Y NF V O F Q P H AC BD
G769 m X Y NF V O F Q P H AC BD
G770 m R=1,2,4 D K AC BD WT E WE V O F Q P H AN
G771 m R=1,2 D K AC BD WE F Q P H AN
G772 m R=1,2 C AC BD WE F Q P H AN
G773 m R=1,2 C E RB RC AC BD KC WE F Q P H AN
G775 m R=1,2,3,4 K E=0,2 RB RC XE BD X BE WT AT FP WE F Q P H AN
G776 m R=1,2,3,4 K E=0,2 RB RC ZE BD Z BE WT AT FP WE F Q P H AN
G777 m R=1,2,3,4 K RB RC YE BD Y BE WT AT FP WE F Q P H AN
G778 m R=1,2,3,4 K RB RC YE BD Y BE WT AT FP WE F Q P H AN
G780 m R=1,2 D=1,2 K C RC A IC AC BD KC WE F Q P H AN
G781 m R=1,2 D=1,2 K C RC A IC AC BD KC WE F Q P H AN
G782 m R=1,2 D=1,2 K C RC A IC AC BD KC WE F Q P H AN
G783 m R=1,2 D=1,2 K C RC A IC AC BD KC WE F Q P H AN
G785 m R=0,1,2,3 BR=0,1 K C RC D WB I J WE F Q NF P H AN
G786 m R=0,1,2,3 K C AC RC WB I J D WS WC BD BE WE F Q NF P H AN
G787 m R=1,2,3 D=0,1,2,3,4,5 K WS WC AC BE RC BD WT FP WE F Q NF P H AN BR
G788 m NF P=0,1
G791 m X C XK YK K A ZE ZS J P F
G792 m Z C K A XE XS J P F
G793 m ZS! ZE! P U R I K F E H=0,1 Q=0,1,2,3 O=0,1
G794 m XS! XE! P U R K I F E H=0,1 Q=0,1,2,3 O=0,1
G797 m ID NS X ZS ZE B V R A Q=0..127 P U I K F E H=0,1 O=0,1 J=0,1
G798 m X! Z! C F! P K U! I E D
G799 m ID NS I Z K R F J=0,1 H=0,1 V=0,1
G800 m ID NS I Z K R F J=0,1 H=0,1 V=0,1
G801 m X C XK YK Z RB ID NF NS W H E V=0,1,2 D F O=0,1
G802 m Z C CY X RB ID NF NS W H E V D F O=0,1
G803 m X Y Z RB ID NF NS W H E F O=0,1
G804 m Y Z X RB ID NF NS W H E F O=0,1
G806 m ID NS I X K R F J=0,1 H=0,1 V=0,1
G808 m Z K! C H=0,1 Q=0,1,2,3 AC=0,1,2,3 A! B! J! W WC S F D=3,4 P I E O R V U
G809 m X Z R! P I K ZS XE D V Q=0,1 EC=1,-1 WE=0,1,2 O
G810 m ID NS NE P I K E X Z A W H=0,1,2 Q=0,1,2 V=0,1,2,3,4 D U=0,1 O=0,1 B RH=0,1,2,3,4 J XA ZA
G820 m ID NS NE P I K E X Z A W H=0,1,2 Q=0,1,2 V=0,1,2,3,4 D U=0,1 O=0,1 B RH=0,1,2,3,4 J XA ZA
G830 m ID NS NE P I K X Z A W Q=0,1,2 V=0,1,2,3,4 D B=0,1,2 H=0,1 RH=0,1,2,3,4 J XA ZA
G835 m ID NS NE P I K X Z A W Q=0,1,2 V=0,1,2,3,4 D B=0,1,2 H=0,1 RH=0,1,2,3,4 J XA ZA
G840 m Q=0,1,2,3,4,5 ID NS NE D V A=0,1 NF=1..127 WB BF=0,1,2,3,4 H=0,1 I F E R P XS ZS RB O=0,1 J B
G841 m ID NS P I K U V F RB
G842 m ID NS P H=0,1 U V F RB
G843 m ID NS P I K U V F RB
G844 m ID NS P H=0,1 U V F RB
G845 m ID NS B XS ZS I K Q=0,1 A=0,1,2 NF=1..127 WB P U V H=0,1 F E FP RB O=0,1,2,3,4,5,6,7 W WE
G846 m ID NS B P XS ZS R U V H=0,1 F E FP RB Q=0,1 O=0,1
G847 m Q=0,1,2 ID NS NE BF=0,1,2,3,4 H=0,1 BR R FP AL U HC=0,1 I O F W WB RB A=0,1 NF=1..127 P XS ZS
G848 m ID NS H=0,1 BR R FP AL O F W WB U J=0,1,2 P I K RB B XS ZS A=0,1 NF=1..127
G851 m I K W R B RB WB E H=0,1 U
G852 m I K W R P A B RB WB E H=0,1 U
G853 m FP I K W R P B RB WB E H=0,1
G856 m I K B
G857 m X Z K R W
G858 m X Z I!
G859 m X Z XE B D I E SD U K
G860 m ID NS NE I K Q=0,1,2,3,4 X Z V=0,1,2,3 E EW EC D H=0,1,2 B P O=0,1 U=0,1,2
G869 m ID NS NE P! R I K X Z A W Q=0,1,2 U=0,1 H=0,1,2 V=0,1,2,3 O E B XA ZA
G870 m ID NS I E
G890 m ID NS NE E V=0,1,2,3,4 Q=0,1,2,3,4 H=0,1,2,3,4,5,6,7 X Z D I K O=0,1 U=0,1,2,3,4,5 B=0,1,2,3,4,5 HR=0,1,2,3,4
G891 m ID NS NE V=0,1,2,3,4 D Q=0,1,2,3 H=3,4,5,6,7,8 AC ZC AR AN U=0,1,2,3,4 RB=0,1 IC JC KC RC O=0,1 B=0,1,2 X Z A W SL E
G895 m ID NS NE V=0,1,2,3,4 D X Z A W P PZ PT I K Q=0,1,2,3 H=3,6,7,8 AR AN U=0,1,2,3,4 IC JC KC RC C=0,1,2,3,4,5 EC=0,1 AS=0,1
  SL E EW B=0,1,2
G901 m
G902 m
G903 m
G904 m
G905 m Q C
G908 m H=0,1,2
G909 m
G910 m V=0,1 D
G911 m V=0,1 R
G912 m Q=0,1
G913 m
G914 m
G916 m H D=1..9 K R V O
G917 m H D! K! O=0,1
G919 m Q H=0,1,2
G920 m
G921 m
G923 m X Z U W H=0,1 Q=1,2
G924 m Q K I H!=0,1
G925 m H Q! P=0,1
G927 m H=0,1,2,3 X Y Z
G928 m H!=0,1 E D=0,1 Q=0,1,2,3
G930 m H Q=1..9 K D
G931 m H!=0,1,2 B
G932 m H=0,1,2 R W
G939 m ID
G940 m H=0,1
G941 m ID R
G976 m Z K I J H!=0,1
G977 m H!=0,1 A W R
G980 m
G981 m
G995 m H=1..99 ID
G996 m Q=0,1,2 H=0,1,2
G999 m Q
'''


class Word:
    """A word as the manual lists it with its code."""

    def __init__(self, text):
        name, _, values = text.partition('=')
        self.required = name.endswith('!')
        self.name = name.rstrip('!')
        self.values = values_of(values) if values else None


def values_of(text):
    first, dots, last = text.partition('..')
    return range(int(first), int(last) + 1) if dots else [int(value) for value in text.split(',')]


def read():
    rows = ROWS.strip().replace('\n  ', ' ').split('\n')
    return {(code, place): {word.name: word for word in map(Word, words)} for code, place, *words in (row.split() for row in rows)}


WORDS = read()
