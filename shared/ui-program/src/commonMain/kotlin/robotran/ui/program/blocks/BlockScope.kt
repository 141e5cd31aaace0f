package robotran.ui.program.blocks

import androidx.compose.runtime.Immutable
import androidx.compose.ui.unit.TextUnit
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import robotran.blockediting.BlockEdit
import robotran.blockediting.freeName
import robotran.blockediting.messages.BlockMessages
import robotran.blockediting.shown.ShownLine
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.language.decimal
import robotran.language.source.SourceSpan
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.inEnglish
import robotran.robolang.words.written
import robotran.ui.code.BlockLooks
import robotran.uikit.*
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.BlocksState
import robotran.workshop.event.BlockEvent

/**
 * What all rows and sheets of blocks need.
 *
 * @property introduced the ids of the blocks that the palette has; null for all.
 * @property isIntroductionFixed whether the pupil cannot ask for all other blocks, because an assignment allows no others.
 * @property brick the brick of the robot, which has its own blocks.
 * @property sensors what is plugged into it.
 * @property onHelp shows help on a word of Robolang.
 */
@Immutable
internal data class BlockScope(
    val state: BlocksState,
    val looks: BlockLooks,
    val messages: BlockMessages,
    val codeSize: Float,
    val introduced: Set<String>?,
    val isIntroductionFixed: Boolean = false,
    val brick: BrickKind,
    val sensors: Set<SensorKind> = setOf(SensorKind.TOUCH, SensorKind.LIGHT),
    val onHelp: (word: String) -> Unit = {},
    val onEvent: (BlockEvent) -> Unit,
) {
    /** The size of the words on blocks. */
    val wordSize: TextUnit get() = codeSize.sp

    fun textOf(span: SourceSpan): String = span.textIn(state.program.text)

    fun textOf(part: PhrasePart): String = textOf(part.span)

    /** The number that is written at [part]; null if something else is there. */
    fun numberIn(part: PhrasePart): Double? =
        if (part is PhrasePart.Value) textOf(part).takeIf { NUMBER.matches(it) }?.toDoubleOrNull() else null

    /** A name for a new variable that the program does not have yet. */
    fun freeName(): String = state.program.freeName("x")

    /** The line of the program, without its comment. */
    fun sourceOf(line: OutlineLine): String =
        textOf(SourceSpan(line.span.start, line.comment?.start ?: line.span.end)).trim()

    /** The line as its block shows it, without its comment. */
    fun wordsOf(line: OutlineLine): String =
        if (line.form == null) sourceOf(line) else ShownLine(state.program, line).sentence

    /** What [part] shows: a word, a name, or a whole value. */
    fun labelOf(part: PhrasePart): String = lineOf(part).labelOf(part)

    /** The line of [part] as its block shows it. */
    fun lineOf(part: PhrasePart): ShownLine = ShownLine(state.program, state.program.lineAt(part.span.start))

    /** [english], a piece of a program, in the words that blocks show. */
    fun shown(english: String): String = state.program.shown.written(english)

    /** The number [text] with the decimal sign that blocks show. */
    fun shownNumber(text: String): String = state.program.shown.language.decimal(text)

    /** [text] of this program in the words of English. */
    fun inEnglish(text: String): String = state.program.vocabulary.inEnglish(text)

    fun edit(edit: BlockEdit) = onEvent(BlockEvent.Edited(edit))

    /** Puts [text] at the part whose sheet is open. */
    fun put(text: String) = onEvent(BlockEvent.Put(text))

    fun show(sheet: BlockDialog?) = onEvent(BlockEvent.DialogShown(sheet))
}

private val NUMBER = Regex("-?\\d+(\\.\\d+)?")

/** The sizes of blocks. */
internal object BlockSizes {
    /** The column with line numbers and breakpoints. */
    val GUTTER = 48.dp

    /** How much further right a block is than the one around it. */
    val INDENT = 18.dp

    /** The bar beside what is inside of a block. */
    val BAR = 12.dp

    /** The part of a block at its start by which a finger carries it at once. */
    val GRIP = 24.dp

    /** The space above each block. */
    val GAP = 2.dp

    val CORNER = Corners.SMALL

    /** The space between the widest blocks and the edge of the pane. */
    val END = 8.dp
}
