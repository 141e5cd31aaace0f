package robotran.ui.program.blocks

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import robotran.blockediting.describe.describe
import robotran.robolang.outline.PhrasePart
import robotran.ui.program.editor.editorStyle
import robotran.ui.theme.RobotranColours
import robotran.workshop.blocks.BlockSheet

/** A value, a name, a text or a choice. A touch opens its sheet. A value with others inside shows them in turn. */
@Composable
internal fun Socket(
    part: PhrasePart,
    scope: BlockScope,
    look: BlockLook,
    unit: String?,
    modifier: Modifier = Modifier,
) {
    val isOpen = (scope.state.sheet as? BlockSheet.Part)?.span == part.span
    val isAt = scope.state.part == part.span
    val shape = RoundedCornerShape(if (part is PhrasePart.Value) VALUE_CORNER else CORNER)
    val spoken = describe(scope.state.program, part, scope.messages).sentence
    Row(
        modifier
            .socketPlace(part, isAt)
            .testTag("socket-${part.span.start}-${part.span.end}")
            .defaultMinSize(MIN_WIDTH, MIN_HEIGHT)
            .clip(shape)
            .background(look.socket)
            .border(
                if (isOpen || isAt) RING else LINE,
                if (isOpen || isAt) RobotranColours.YELLOW else look.edge,
                shape,
            )
            // The list as a whole has the keyboard's focus.
            .focusProperties { canFocus = false }
            .clickable(role = if (part is PhrasePart.Choice) Role.DropdownList else Role.Button) {
                scope.show(BlockSheet.Part(part.span))
            }
            .semantics { contentDescription = spoken }
            .padding(horizontal = 10.dp),
        Arrangement.spacedBy(6.dp, Alignment.CenterHorizontally),
        Alignment.CenterVertically,
    ) {
        val inner = (part as? PhrasePart.Value)?.value?.parts.orEmpty()
        if (scope.numberIn(part) != null || inner.none { isSocket(it, part) }) {
            Written(scope.textOf(part), scope, look)
            if (part is PhrasePart.Choice) Written("▾", scope, look)
        } else {
            val inside = look.copy(ink = look.socketInk)
            for (each in inner) LinePart(each, scope, inside, unit = null)
        }
        if (unit != null) {
            Text(unit, Modifier.clearAndSetSemantics { }, color = look.socketInk, fontSize = UNIT_SIZE.sp)
        }
    }
}

/** Whether a part of a value is a socket of its own; a name alone is the same as the value that it stands for. */
private fun isSocket(inner: PhrasePart, outer: PhrasePart): Boolean =
    inner !is PhrasePart.Word && inner.span != outer.span

@Composable
private fun Written(text: String, scope: BlockScope, look: BlockLook) = Text(
    text,
    Modifier.clearAndSetSemantics { },
    style = editorStyle(scope.codeSize).copy(color = look.socketInk),
)

private val MIN_WIDTH = 48.dp

/** Blocks are 48 dp high; a touch beside the socket counts for it, too. */
private val MIN_HEIGHT = 38.dp
private val VALUE_CORNER = 19.dp
private val CORNER = 8.dp
private val LINE = 1.dp
private val RING = 3.dp
private const val UNIT_SIZE = 13
