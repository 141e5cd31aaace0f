package robotran.ui.program.blocks

import robotran.blockediting.BlockProgram
import robotran.blockediting.fits
import robotran.blockediting.kindOf
import robotran.blockediting.palette.PaletteBlock
import robotran.blockediting.palette.valueKind
import robotran.language.source.SourceSpan
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.ValueKind

/**
 * A value that a finger carries.
 *
 * @property span where it comes from; null for one of the palette.
 */
internal class CarriedValue private constructor(val span: SourceSpan?, private val kind: ValueKind) {
    constructor(part: PhrasePart.Value, program: BlockProgram) : this(part.span, program.kindOf(part.value))

    constructor(block: PaletteBlock) : this(null, block.valueKind)

    /** Whether it may be put at [part], as far as is known; never in itself. */
    fun fitsAt(part: PhrasePart.Value): Boolean = (span == null || part.span !in span) && fits(kind, part.use)
}
