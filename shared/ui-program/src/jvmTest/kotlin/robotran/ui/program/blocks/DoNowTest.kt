package robotran.ui.program.blocks

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performTouchInput
import robotran.ui.program.keys
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.checkTargets
import robotran.ui.screen.pass
import robotran.ui.screen.touch
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.event.BlockEvent
import robotran.workshop.state.Pane
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** Tests blocks that run at once, and what a number shows on the sheet. */
@OptIn(ExperimentalTestApi::class)
class DoNowTest {
    /** That [act] makes the robot drive and leaves the program alone. */
    private fun ComposeUiTest.drives(workshop: Workshop, act: () -> Unit) {
        val text = workshop.text
        val before = workshop.state.session.robot.pose
        act()
        assertTrue(workshop.state.session.brick.isSnippet)
        pass(3_000)
        assertNotEquals(before, workshop.state.session.robot.pose)
        assertEquals(text, workshop.text)
    }

    @Test
    fun `a block of the palette is tried on a phone, which shows the robot`() = onPhoneInBlocks(PROGRAM) { workshop ->
        touch(ProgramTags.BLOCKS_ADD)
        checkTargets(ProgramTags.now("move"), ProgramTags.take("move"))
        assertEquals(0, onAllNodesWithTag(ProgramTags.now("power")).fetchSemanticsNodes().size)
        drives(workshop) { touch(ProgramTags.now("move")) }
        assertEquals(Pane.WORLD, workshop.state.pane)
    }

    @Test
    fun `a block is tried from what can be done to it`() = onTabletInBlocks(PROGRAM) { workshop ->
        touch(ProgramTags.block("1"))
        touch(ProgramTags.BLOCK_MORE)
        drives(workshop) { touch(ProgramTags.action(ProgramTags.NOW)) }
    }

    @Test
    fun `a block is tried by keys`() = onTabletInBlocks(PROGRAM) { workshop ->
        focusBlocks()
        workshop.handle(BlockEvent.CursorPut(BlockCursor.At(blockOf(workshop, "forward 20"))))
        pass(100)
        drives(workshop) {
            keys(listOf(Key.Enter), with = Key.AltLeft)
        }
    }

    @Test
    fun `a screen reader can try a block`() = onTabletInBlocks(PROGRAM) { workshop ->
        val actions = onNodeWithTag(ProgramTags.block("1")).fetchSemanticsNode().config[SemanticsActions.CustomActions]
        drives(workshop) {
            actions.single { it.label == "Do this now" }.action()
            pass(100)
        }
    }

    @Test
    fun `the number says what it does, and its end on the sheet is dragged`() = onTabletInBlocks(PROGRAM) { workshop ->
        touch(socketOf(PROGRAM, "20"))
        assertEquals("20 cm ahead", said())
        checkTargets(WorldTags.PREVIEW_END)
        onNodeWithTag(WorldTags.PREVIEW_END).performTouchInput {
            down(center)
            moveBy(Offset(60f, 0f))
            moveBy(Offset(60f, 0f))
        }
        pass(200)
        onNodeWithTag(WorldTags.PREVIEW_END).performTouchInput { up() }
        pass(200)
        val number = workshop.text.substringAfter("forward ").substringBefore('\n').toInt()
        assertTrue(number > 25, "$number")
        assertEquals("$number cm ahead", said())
        touch(ProgramTags.BLOCK_SHEET_CLOSE)
        assertEquals(0, onAllNodesWithTag(WorldTags.PREVIEW_END).fetchSemanticsNodes().size)
        touch(ProgramTags.UNDO)
        assertEquals(PROGRAM, workshop.text)
    }

    @Test
    fun `a ruler on the sheet leaves the end of the number to the finger`() = onTabletInBlocks(PROGRAM) { workshop ->
        touch(WorldTags.SHEET_MEASURE)
        touch(socketOf(PROGRAM, "20"))
        val measured = workshop.state.sheet.measuring
        assertNotNull(measured)
        onNodeWithTag(WorldTags.PREVIEW_END).performTouchInput {
            down(center)
            moveBy(Offset(60f, 0f))
            moveBy(Offset(60f, 0f))
            up()
        }
        pass(200)
        assertTrue(workshop.text.substringAfter("forward ").substringBefore('\n').toInt() > 25, workshop.text)
        assertEquals(measured, workshop.state.sheet.measuring)
    }

    @Test
    fun `a phone shows a small picture of the sheet while a number is edited`() = onPhoneInBlocks(PROGRAM) {
        touch(socketOf(PROGRAM, "20"))
        val picture = onNodeWithTag(WorldTags.MINI_SHEET).fetchSemanticsNode().boundsInRoot
        val sheet = onNodeWithTag(ProgramTags.BLOCK_SHEET_CLOSE).fetchSemanticsNode().boundsInRoot
        assertTrue(picture.bottom <= sheet.top, "$picture, $sheet")
        touch(ProgramTags.BLOCK_SHEET_CLOSE)
        assertEquals(0, onAllNodesWithTag(WorldTags.MINI_SHEET).fetchSemanticsNodes().size)
    }

    private fun ComposeUiTest.said(): String? =
        onNodeWithTag(ProgramTags.NUMBER).fetchSemanticsNode().config.getOrNull(SemanticsProperties.StateDescription)

    private fun blockOf(workshop: Workshop, label: String) = checkNotNull(workshop.state.programs.blocks).program.let {
        it.all.first { block -> block.head.span.textIn(it.text).trim() == label }.id
    }

    private companion object {
        const val PROGRAM = "pen down\nforward 20\nturn left 135\n"
    }
}
