package robotran.ui.program.blocks

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.FlowRowScope
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.CutCornerShape
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.graphics.Shape
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import robotran.blockediting.describe.describe
import robotran.blockediting.shown.ShownPiece
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.ValueKind
import robotran.ui.code.BlockLook
import robotran.ui.program.editor.editorStyle
import robotran.ui.program.tags.ProgramTags
import robotran.uikit.*
import robotran.workshop.blocks.BlockDialog

/**
 * A value, a name, a text or a choice. A touch opens its sheet. A value with others inside shows them in turn, and wraps
 * them where the line is too narrow.
 *
 * @param depth how many sockets are around it.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun Socket(
    part: PhrasePart,
    scope: BlockScope,
    look: BlockLook,
    unit: String?,
    modifier: Modifier = Modifier,
    depth: Int = 0,
) {
    val isOpen = (scope.state.sheet as? BlockDialog.Part)?.span == part.span
    val isAt = scope.state.part == part.span
    val inner = innerParts(part, scope)
    val own = if (inner.isEmpty()) look else scope.looks.of((part as PhrasePart.Value).value.form.group)
    val shape = shapeOf(part)
    val spoken = describe(scope.state.program, part, scope.messages).sentence
    FlowRow(
        modifier
            .socketPlace(part, isAt)
            .testTag(ProgramTags.socket(part.span.start, part.span.end))
            .defaultMinSize(if (depth == 0) MIN_WIDTH else MIN_WIDTH_INSIDE, lineHeight(depth))
            .clip(shape)
            .background(if (inner.isEmpty()) look.socket else own.tint)
            .border(
                if (isOpen || isAt) RING else LINE,
                if (isOpen || isAt) RobotranColours.YELLOW else own.edge,
                shape,
            )
            // The list as a whole has the keyboard's focus.
            .focusProperties { canFocus = false }
            .clickable(role = if (part is PhrasePart.Choice) Role.DropdownList else Role.Button) {
                scope.show(BlockDialog.Part(part.span))
            }
            .named(spoken)
            .padding(horizontal = if (isCondition(part)) CUT else BESIDE, vertical = SOCKET_INSET),
        Arrangement.spacedBy(4.dp, if (inner.isEmpty()) Alignment.CenterHorizontally else Alignment.Start),
        Arrangement.spacedBy(SOCKET_INSET, Alignment.CenterVertically),
    ) {
        if (inner.isEmpty()) {
            Written(scope.labelOf(part), scope, look, middle())
            if (part is PhrasePart.Choice) Box(middle()) { IconView(ThinIcons.DOWN, look.socketInk, size = SIGN) }
        } else {
            val inside = own.copy(ink = own.socketInk)
            for (piece in scope.lineOf(part).piecesOf(part as PhrasePart.Value)) {
                when (piece) {
                    is ShownPiece.Words -> BlockWords(piece.text, scope, inside, onLine(depth + 1))
                    is ShownPiece.Part -> LinePart(piece.part, scope, inside, unit = null, onLine(depth + 1), depth + 1)
                }
            }
        }
        if (unit != null) {
            val place = if (inner.isEmpty()) middle() else onLine(depth + 1)
            Text(unit, place.clearAndSetSemantics { }, TextStyle(fontSize = UNIT_SIZE.sp), color = look.socketInk)
        }
    }
}

/** The parts of a value with sockets of its own; empty for others. A name alone is the value that it stands for. */
private fun innerParts(part: PhrasePart, scope: BlockScope): List<PhrasePart> {
    val inner = (part as? PhrasePart.Value)?.value?.parts.orEmpty()
    val hasSockets = inner.any { it !is PhrasePart.Word && it.span != part.span }
    return if (hasSockets && scope.numberIn(part) == null) inner else emptyList()
}

private fun isCondition(part: PhrasePart): Boolean = part is PhrasePart.Value && part.use.kind == ValueKind.CONDITION

/** Numbers are round and conditions pointed, so that a pupil sees what fits where. */
private fun shapeOf(part: PhrasePart): Shape = when {
    isCondition(part) -> CutCornerShape(CUT)
    part is PhrasePart.Value -> RoundedCornerShape(VALUE_CORNER)
    else -> RoundedCornerShape(CORNER)
}

@Composable
private fun Written(text: String, scope: BlockScope, look: BlockLook, modifier: Modifier) = Text(
    text,
    modifier.clearAndSetSemantics { },
    editorStyle(scope.codeSize).copy(color = look.socketInk),
)

@OptIn(ExperimentalLayoutApi::class)
private fun FlowRowScope.middle(): Modifier = Modifier.align(Alignment.CenterVertically)

private val MIN_WIDTH = 48.dp

/** A touch beside a smaller socket counts for it, too. */
private val MIN_WIDTH_INSIDE = 40.dp
private val BESIDE = 8.dp
private val VALUE_CORNER = Corners.SHEET
private val CORNER = Corners.SMALL
private val CUT = 12.dp
private val SIGN = 10.dp
private val LINE = 1.dp
private val RING = 3.dp
private const val UNIT_SIZE = 13
