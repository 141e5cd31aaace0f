"""Makes shared/ui-common/src/wasmJsMain/composeResources/files/noto_emoji.ttf of NotoEmoji_400Regular.ttf (docs/third-party.md says from where).

All emoji stay. Their outlines get fewer points on a coarser grid, at most 10 of 2048 units, a tenth of a pixel in a text of 20 pixels, beside
where they were; metrics for vertical text go. Needs fontTools 4.

usage: shrink-emoji.py NotoEmoji_400Regular.ttf noto_emoji.ttf
"""
import sys

from fontTools.pens.cu2quPen import Cu2QuPen
from fontTools.pens.qu2cuPen import Qu2CuPen
from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTFont
from fontTools.ttLib.scaleUpem import scale_upem

UNITS_PER_EM = 512
TOLERANCE = 10  # in the font's own 2048 units


def simplified(glyph):
    outline = DecomposingRecordingPen(glyphs)
    glyph.draw(outline)
    pen = TTGlyphPen(None)
    outline.replay(Qu2CuPen(Cu2QuPen(pen, TOLERANCE, all_quadratic=True), TOLERANCE, all_cubic=True))
    return pen.glyph(dropImpliedOnCurves=True)


source, target = sys.argv[1:]
font = TTFont(source, recalcTimestamp=False)
glyphs = font.getGlyphSet()
for name, outline in [(name, simplified(glyphs[name])) for name in font.getGlyphOrder()]:
    font["glyf"][name] = outline
for table in ("vhea", "vmtx", "STAT"):
    del font[table]
scale_upem(font, UNITS_PER_EM)
font.save(target)
