package robotran.blockediting

import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.outline.LineRole
import robotran.robolang.words.LineForm

/** The blocks of [run]; null if there are none. */
internal fun BlockProgram.blocksOf(run: BlockRun): List<Block>? {
    val place = placeOf(run.first) ?: return null
    val siblings = checkNotNull(blocksAt(place.parent, place.slot))
    val end = if (run.count < siblings.size - place.index) place.index + run.count else siblings.size
    return siblings.subList(place.index, end).takeIf { it.isNotEmpty() }
}

/** The lines of [run]; null if there are none. */
internal fun BlockProgram.linesOf(run: BlockRun): IntRange? =
    blocksOf(run)?.let { it.first().lines.first..it.last().lines.last }

/** The number of blocks around [place]. */
internal fun BlockProgram.depthAt(place: BlockPlace): Int =
    place.parent?.let { checkNotNull(get(it)).head.depth + 1 } ?: 0

/** The indentation of the first of [rows] that is not blank. */
internal fun baseIndentation(rows: List<Row>): String =
    rows.firstOrNull { !it.isBlank }?.let { indentationOf(it.content) }.orEmpty()

/**
 * The indentation of a line at [place]: that of the nearest block of the same branch, those above first; otherwise one
 * level more than the line around it.
 *
 * @param without blocks that do not count.
 */
internal fun BlockProgram.indentationAt(place: BlockPlace, without: Set<BlockId> = emptySet()): String {
    val siblings = checkNotNull(blocksAt(place.parent, place.slot))
    val above = siblings.subList(0, place.index).asReversed()
    val below = siblings.subList(place.index, siblings.size)
    val near = (above.asSequence() + below).firstOrNull {
        it !is Block.Blank && it !is Block.Loose && it.id !in without
    }
    if (near != null) return indentationOf(near.head.span.textIn(text))
    val parent = place.parent?.let { checkNotNull(get(it)) } ?: return ""
    return indentationOf(parent.head.span.textIn(text)) + INDENTATION
}

/** Why [blocks] may not stand at [place]; null if they may. [known] are those that are in the program already. */
internal fun BlockProgram.errorAt(
    place: BlockPlace,
    blocks: List<Block>,
    known: Set<BlockId> = emptySet(),
): BlockEditError? {
    val isInRobot = place.parent?.let { get(it) }?.head?.form == LineForm.ROBOT
    for (block in blocks) {
        val form = block.head.form
        val isSetting =
            form?.isSetting == true || block.head.error?.code == DiagnosticCode.SETTING_OUTSIDE_ROBOT
        val isRead = block is Block.Command || block is Block.Construct
        when {
            isInRobot && isRead && !isSetting -> return BlockEditError.OnlySettings
            !isInRobot && isSetting -> return BlockEditError.SettingOutsideRobot
            form?.isOutermost == true && place.parent != null -> return BlockEditError.OnlyOutermost
            form == LineForm.ROBOT && hasRobotBut(known) -> return BlockEditError.SecondRobot
        }
    }
    return null
}

private fun BlockProgram.hasRobotBut(known: Set<BlockId>): Boolean =
    blocks.any { it.head.form == LineForm.ROBOT && it.id !in known }

/** Whether a line of this role says something. */
internal val LineRole.isStatement: Boolean get() = this != LineRole.BLANK && this != LineRole.COMMENT
