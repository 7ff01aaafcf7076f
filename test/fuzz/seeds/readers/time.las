~VERSION INFORMATION
 VERS.  2.0 : CWLS
 WRAP.  NO : one line
~WELL
 STRT.S 0 : start
 NULL.  -999.25 : null
# a comment
~CURVE
TIME.S : time
HKLD.KLBF : hook load
BPOS.FT : block
~PARAMETER
~ASCII LOG DATA
0  200  30
5  201  29.5
10  202.5  29
15  203  28
