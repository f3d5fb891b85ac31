"""The classes of slips in whole DIN PLUS programs, and what share of each is found."""

# (group, severity, classes): (class, rules that name its cause, what it is)
ROWS = [
    ('parameters', 'error', [
        ('din-word-missing', 'MAC523 MAC577 MAC580', 'a word that its code cannot be without is gone'),
        ('din-word-twice', 'MAC559', 'a word stands twice in its block'),
        ('din-decimal-comma', 'MAC126 MAC121', 'a comma for the decimal point'),
    ]),
    ('parameters', 'warning', [
        ('din-word-value', 'MAC576 DIN902 DIN109', 'a word has a value that its code does not take'),
        ('din-word-unknown', 'MAC581 MAC579 MAC578', 'a word of another code'),
        ('din-words-exclude', 'MAC575 MAC581 MAC579', 'two words that exclude each other'),
    ]),
    ('order', 'error', [
        ('din-section-gone', 'MAC527 MAC580 DIN205 DIN704 DIN706 DIN225', 'the word of a section with a contour is gone'),
        ('din-pocket-not-begun', 'DIN225', 'G308 is gone'),
        ('din-pocket-not-ended', 'DIN225', 'G309 is gone'),
        ('din-contour-without-start', 'MAC580 MAC527', 'G0 at the beginning of a contour is gone'),
        ('din-pattern-behind-figure', 'MAC580', 'a pattern of holes or figures stands behind its figure'),
        ('din-g80-removed', 'MAC580 MAC579', 'G80 at the end of a contour behind its cycle is gone'),
    ]),
    ('order', 'warning', [
        ('din-sections-exchanged', 'DIN105 DIN106 DIN109 MAC527', 'the words of two sections have changed their places'),
        ('din-tool-before-retract', 'MAC534 MAC580', 'T behind the work in front of the G14 that belongs before it'),
        ('din-codes-exchanged', 'MAC580 MAC527', 'G910 and G911, G740 and G860, and so on, the other way round'),
    ]),
    ('needs', 'warning', [
        ('din-c-axis-gone', 'MAC527 MAC580', 'M14 in front of codes of the C axis is gone'),
        ('din-spindle-gone', 'MAC527 MAC554', 'the spindle is never started'),
        ('din-spindle-stopped', 'MAC527 MAC554', 'M5 where the spindle is started'),
        ('din-feed-gone', 'MAC527 MAC553', 'no feed before the first work'),
        ('din-speed-gone', 'MAC528 MAC554 MAC523', 'no speed before the first work'),
        ('din-tool-gone', 'MAC527 MAC580', 'no tool before the first work'),
        ('din-limit-gone', 'MAC570 MAC527', 'G26 is gone, and a cycle faces to the axis under G96'),
        ('din-lateral-diameter-gone', 'MAC527 MAC580', 'G120 in front of CY is gone'),
        ('din-probe-start-gone', 'MAC527 MAC580', 'G910 in front of G911 is gone'),
        ('din-measured-value-gone', 'MAC527 MAC580', 'G787 in front of G788 is gone'),
        ('din-change-point-gone', 'MAC527 MAC580', 'G140 of the point that G14 D names is gone'),
        ('din-plane-gone', 'MAC527 MAC580', 'G17 or G19 in front of milling with the Y axis is gone'),
    ]),
    ('left on', 'warning', [
        ('din-coupling-left', 'MAC586', 'G720 H0 is gone'),
        ('din-eccentric-left', 'MAC586', 'G725 H0, G726 H0 or G727 H0 is gone'),
        ('din-override-left', 'MAC586', 'G908 H2 or G919 H0 is gone'),
        ('din-tcpm-left', 'MAC586', 'G928 H0 is gone'),
        ('din-zone-left', 'MAC586', 'G995 that closes the zone is gone'),
        ('din-zone-off-left', 'MAC586', 'G60 Q0 is gone'),
        ('din-interrupted-feed-left', 'MAC586', 'G64 without words is gone'),
        ('din-probe-left', 'MAC586', 'G913 is gone'),
        ('din-c-axis-left', 'MAC586 MAC527', 'M15 in front of turning is gone'),
        ('din-attribute-left', 'MAC586', 'an attribute of a contour (G10, G38, G52) goes on'),
    ]),
    ('references', 'error', [
        ('din-reference-nowhere', 'DIN704', 'NS or NE names a block that is not there'),
        ('din-reference-to-machining', 'DIN704 DIN706', 'NS or NE names a block of MACHINING'),
        ('din-reference-to-start', 'DIN706', 'NS of a milling cycle names the start point'),
        ('din-reference-to-other-section', 'DIN705 DIN706', 'NE names a block of another section'),
        ('din-reference-to-other-kind', 'DIN706', 'NS of G870 or of a drilling cycle names a line'),
        ('din-contour-name', 'DIN205', 'the name of a contour is mistyped'),
        ('din-position-mark', 'DIN819', 'NF of positions that no cycle has stored'),
        ('din-tool-not-in-turret', 'DIN118', 'a tool that the turret does not have'),
        ('din-tool-edge', 'DIN119', 'edge 12 of a tool'),
        ('din-pocket-twice', 'DIN117', 'a place of the turret has two tools'),
    ]),
    ('references', 'warning', [
        ('din-contour-name-twice', 'DIN205', 'two contours have one name'),
        ('din-name-mistyped', 'DIN312', 'a constant or variable is mistyped'),
    ]),
    ('slides', 'error', [
        ('din-m97-one-slide', 'DIN902 DIN903', 'of two slides that meet at M97 one does not'),
        ('din-mark-mistyped', 'DIN902', 'a mark of another number'),
        ('din-mark-gone', 'DIN902', 'G162 that a slide waits for is gone'),
    ]),
    ('slides', 'warning', [
        ('din-slide-unknown', 'DIN905', 'a slide that the head does not name'),
        ('din-slide-gone', 'DIN319', 'the slide of a block that calculates is gone'),
    ]),
    ('contour', 'error', [
        ('din-arc-radius', 'DIN662', 'a radius shorter than half of the chord'),
        ('din-arc-centre', 'DIN662', 'a centre beside the one of the arc'),
        ('din-arc-end', 'DIN662', 'an end beside the arc'),
        ('din-arc-closed', 'DIN229', 'the end of an arc is its start'),
        ('din-chamfer-long', 'DIN239', 'a chamfer is longer than its line'),
        ('din-across-axis', 'MAC576 DIN208', 'a contour with turning crosses the axis'),
        ('din-pocket-opened', 'DIN706', 'the last element of a pocket is gone'),
    ]),
    ('contour', 'warning', [
        ('din-outside-blank', 'DIN209', 'the bar is smaller than the part'),
    ]),
    ('flow', 'error', [
        ('din-ends-crossed', 'DIN401 DIN404 DIN409', 'ENDIF and ENDWHILE the other way round'),
        ('din-branch-twice', 'DIN401 DIN412', 'ELSE or DEFAULT stands twice'),
        ('din-three-conditions', 'DIN403', 'a third condition'),
        ('din-case-twice', 'DIN411', 'two CASE of one value'),
    ]),
    ('flow', 'warning', [
        ('din-end-early', 'MAC460', 'M30 in the middle'),
        ('din-loop-never', 'MAC718 MAC321', 'the relation of a loop is turned round'),
        ('din-variable-renamed', 'MAC209 DIN407', 'one reading of a variable has another number'),
        ('din-recursion', 'MAC412', 'a subprogram calls itself'),
    ]),
]
BARS = {}  # class: share that must be found, where it is not the bar of its severity
