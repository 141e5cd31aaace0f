package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.dp
import robotran.blockediting.palette.PaletteBlock
import robotran.blockediting.shown.shownIn
import robotran.learning.WordHelp
import robotran.programs.blockLanguage
import robotran.ui.program.blocks.BlockDragging
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.blocks.Carrier
import robotran.ui.program.blocks.carry
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*

/** A block of the palette, with a sentence about what it does. */
@Composable
internal fun PaletteItem(block: PaletteBlock, scope: BlockScope, dragging: BlockDragging, onTake: () -> Unit) {
    val carrier = remember(block, dragging) { PaletteCarrier(block, dragging) }
    val look = scope.looks.of(block.group)
    val reader = LocalLanguage.current
    val sentence = remember(block, reader, scope.brick) {
        block.explained.firstNotNullOfOrNull {
            WordHelp.of(reader, blockLanguage, it, scope.brick)?.sentence
        }.orEmpty()
    }
    val words = scope.state.program.shown
    val lines = remember(block, words) { block.shownIn(words) }
    val spoken = BlockTexts.addThis(spoken, lines.joinToString(), sentence)
    Column(
        Modifier
            .fillMaxWidth()
            .onGloballyPositioned { carrier.corner = it.positionInRoot() }
            .pointerInput(carrier) { carry(carrier) }
            .focusRing()
            .clip(Shapes.SMALL)
            .clickable(role = Role.Button, onClick = onTake)
            .testTag(ProgramTags.take(block.id))
            .named(spoken),
        Arrangement.spacedBy(2.dp),
    ) {
        PaletteBlockView(block, look, lines)
        if (sentence.isNotEmpty()) {
            Text(
                sentence,
                Modifier.padding(horizontal = 4.dp).clearAndSetSemantics { },
                TextStyles.caption,
                color = LocalRobotranColours.current.quiet,
            )
        }
    }
}

/** Carries [block] out of the palette, over the list of [dragging]. */
private class PaletteCarrier(private val block: PaletteBlock, private val dragging: BlockDragging) : Carrier {
    /** The upper left corner of the block in the palette, in pixels on the screen. */
    var corner = Offset.Zero

    override fun isGrip(position: Offset): Boolean = false

    override fun take(position: Offset): Boolean {
        dragging.takeNew(block, onList(position))
        return true
    }

    override fun moveTo(position: Offset) = dragging.moveTo(onList(position))

    override fun drop() = dragging.drop()

    override fun cancel() = dragging.cancel()

    private fun onList(position: Offset): Offset = position + corner - dragging.corner
}
