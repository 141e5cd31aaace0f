package robotran.ui.program.blocks

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.dp
import robotran.blockediting.palette.PaletteBlock
import robotran.blockediting.shown.shownIn
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import robotran.workshop.blocks.DragPayload
import robotran.workshop.event.BlockEvent

/** Runs [load] at once, from where the robot stands. */
internal fun BlockScope.doNow(load: DragPayload) = onEvent(BlockEvent.SnippetRequested(load))

/** The button that runs [block] of the palette at once; nothing if nobody would see or hear what it does. */
@Composable
internal fun DoNowButton(block: PaletteBlock, scope: BlockScope) {
    if (!block.canBeTried) return
    val words = BlockTexts.doNowThis(spoken, block.shownIn(scope.state.program.shown).joinToString())
    val colours = LocalRobotranColours.current
    Box(
        Modifier
            .testTag(ProgramTags.now(block.id))
            .size(Dimensions.TARGET)
            .focusRing(Dimensions.TARGET / 2)
            .clip(CircleShape)
            .border(1.dp, colours.quiet, CircleShape)
            .clickable(role = Role.Button) { scope.doNow(DragPayload.New(block)) }
            .named(words),
        Alignment.Center,
    ) {
        Canvas(Modifier.size(TRIANGLE)) {
            // The triangle is centred by its weight.
            val path = Path().apply {
                moveTo(size.width * LEFT, 0f)
                lineTo(size.width * (1 + LEFT), size.height / 2)
                lineTo(size.width * LEFT, size.height)
                close()
            }
            drawPath(path, colours.onPane)
        }
    }
}

private val TRIANGLE = 18.dp
private const val LEFT = 0.15f
