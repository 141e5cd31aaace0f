package robotran.ui.program.blocks

import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRowScope
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.wrapContentHeight
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.coerceAtLeast
import androidx.compose.ui.unit.dp
import robotran.blockediting.shown.ShownLine
import robotran.blockediting.shown.ShownPiece
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart
import robotran.ui.code.BlockLook
import robotran.uikit.*

/** The words and sockets of [line], one after the other. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun FlowRowScope.LineParts(line: OutlineLine, scope: BlockScope, look: BlockLook) {
    for (piece in ShownLine(scope.state.program, line).pieces) {
        when (piece) {
            is ShownPiece.Words -> BlockWords(piece.text, scope, look, onLine())

            is ShownPiece.Part -> {
                val value = piece.part as? PhrasePart.Value
                val unit = value?.let { unitOf(it, line.parts.getOrNull(piece.index + 1), scope) }
                LinePart(piece.part, scope, look, unit, onLine())
            }
        }
    }
}

/**
 * A word, or a socket with what is in it.
 *
 * @param unit what the number counts; null if the line says that itself.
 * @param depth how many sockets are around it.
 */
@Composable
internal fun LinePart(
    part: PhrasePart,
    scope: BlockScope,
    look: BlockLook,
    unit: String?,
    modifier: Modifier = Modifier,
    depth: Int = 0,
) {
    if (part is PhrasePart.Word) {
        BlockWords(scope.labelOf(part), scope, look, modifier)
    } else {
        Socket(part, scope, look, unit, modifier, depth)
    }
}

/** Words on a block. A screen reader reads the block as a whole. */
@Composable
internal fun BlockWords(label: String, scope: BlockScope, look: BlockLook, modifier: Modifier = Modifier) = Text(
    label,
    modifier.clearAndSetSemantics { },
    TextStyle(fontSize = scope.wordSize, fontWeight = FontWeight.Medium),
    color = look.ink,
)

/** The unit of [value], unless the next word is that unit, such as `seconds`. */
private fun unitOf(value: PhrasePart.Value, next: PhrasePart?, scope: BlockScope): String? {
    val unit = value.use.unit ?: return null
    val word = next?.let { scope.inEnglish(scope.textOf(it)) }?.lowercase() ?: return scope.shown(unit)
    return scope.shown(unit).takeIf { unit.removeSuffix("s") != word.removeSuffix("s") }
}

/** The place of a word or socket: at the middle of its line, or at the top beside a value that takes several lines. */
@OptIn(ExperimentalLayoutApi::class)
internal fun FlowRowScope.onLine(depth: Int = 0): Modifier =
    Modifier.align(Alignment.Top).heightIn(min = lineHeight(depth)).wrapContentHeight(Alignment.CenterVertically)

/** The height of a socket with a short value in [depth] others. Blocks are 48 dp high, with a margin of 4 dp. */
internal fun lineHeight(depth: Int = 0): Dp = (LINE - SOCKET_INSET * 2 * depth).coerceAtLeast(LEAST_LINE)

/** The space around sockets in a socket. */
internal val SOCKET_INSET = 3.dp
private val LINE = 40.dp
private val LEAST_LINE = 32.dp
