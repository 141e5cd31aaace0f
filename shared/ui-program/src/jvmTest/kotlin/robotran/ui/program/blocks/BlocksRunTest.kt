package robotran.ui.program.blocks

import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.hasAnyAncestor
import androidx.compose.ui.test.hasTestTag
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import robotran.brick.kind.BrickKind
import robotran.projects.ProgramView
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.write
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.onScreen
import robotran.ui.screen.pass
import robotran.ui.screen.pixelsOf
import robotran.ui.screen.touch
import robotran.uikit.*
import robotran.workshop.Workshop
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.NoteKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Tests how a run is shown in blocks, in the text beside them, and in Java. */
@OptIn(ExperimentalTestApi::class)
class BlocksRunTest {
    @Test
    fun `the block that runs is lit and says so`() = onTabletInBlocks(SOURCE) { workshop ->
        assertFalse(isLit(ProgramTags.BLOCKS))
        step(3)
        assertEquals(3, workshop.runningLine)
        assertTrue(isLit(ProgramTags.BLOCKS))
        for (line in 1..6) assertEquals(line == 3, says(workshop.tagOf(line)) != null, "line $line")
    }

    @Test
    fun `the line that runs is lit in blocks, in the text and in Java at once`() = onLaptop { workshop ->
        workshop.write(SOURCE, caret = 0)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BOTH))
        workshop.handle(ProgramEvent.TranslationShown(true))
        pass(300)
        for (tag in PANES) assertFalse(isLit(tag), tag)
        step(3)
        for (tag in PANES) assertTrue(isLit(tag), tag)
        touch(RunTags.STOP)
        for (tag in PANES) assertFalse(isLit(tag), tag)
    }

    @Test
    fun `the line that runs on a hub is lit in blocks, in the text and in Python at once`() = onLaptop { workshop ->
        workshop.handle(WorldEditEvent.PenbotChosen(workshop.state.programs.shownRobot, BrickKind.SPIKE_PRIME))
        workshop.write(SOURCE, caret = 0)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BOTH))
        workshop.handle(ProgramEvent.TranslationShown(true))
        pass(300)
        for (tag in PANES) assertFalse(isLit(tag), tag)
        step(3)
        for (tag in PANES) assertTrue(isLit(tag), tag)
        onNodeWithTag(ProgramTags.TRANSLATION_KEEP).assertTextContains("Save the file")
    }

    @Test
    fun `a program stops at the block whose number a finger has touched`() = onTabletInBlocks(SOURCE) { workshop ->
        touch(ProgramTags.blockLine(4))
        touch(RunTags.RUN)
        pass(3_000)
        assertTrue(workshop.state.run.isPaused)
        assertEquals(4, workshop.runningLine)
        assertTrue(says(workshop.tagOf(4)) != null)
        touch(ProgramTags.blockLine(4))
        touch(RunTags.PAUSE)
        pass(8_000)
        assertFalse(workshop.state.running)
    }

    @Test
    fun `steps go into an own command, over it and out of it`() = onTabletInBlocks(OWN) { workshop ->
        touch(RunTags.STEP)
        assertEquals(5, workshop.runningLine)
        step(RunTags.STEP_INTO)
        assertEquals(2, workshop.runningLine)
        step(RunTags.STEP_OUT)
        assertEquals(6, workshop.runningLine)
        step(RunTags.STEP_OVER)
        assertEquals(7, workshop.runningLine)
        assertTrue(says(workshop.tagOf(7)) != null)
    }

    @Test
    fun `the variables of a paused program are shown beside its blocks`() = onTabletInBlocks(SOURCE) { workshop ->
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        step(3)
        onNodeWithTag(RunTags.variable("way")).assertIsDisplayed().assertTextContains("2", substring = true)
        onNodeWithTag(ProgramTags.BLOCK_PANE).assertIsDisplayed()
    }

    @Test
    fun `going back in time lights the block that ran then`() = onTabletInBlocks(SOURCE) { workshop ->
        touch(ProgramTags.blockLine(4))
        touch(RunTags.RUN)
        pass(3_000)
        assertEquals(4, workshop.runningLine)
        workshop.handle(RunEvent.Scrubbed(workshop.state.run.time - 60))
        pass(200)
        assertEquals(3, workshop.runningLine)
        assertTrue(says(workshop.tagOf(3)) != null)
        assertFalse("runs now" in says(workshop.tagOf(4)).orEmpty())
    }

    @Test
    fun `a collapsed block is lit while something in it runs`() = onTabletInBlocks(SOURCE) { workshop ->
        val repeat = workshop.tagOf(2)
        touch(repeat.replace("block-", "fold-"))
        assertEquals(0, onAllNodesWithTag(ProgramTags.blockLine(3)).fetchSemanticsNodes().size)
        step(3)
        assertEquals(3, workshop.runningLine)
        assertTrue(says(repeat) != null)
    }

    @Test
    fun `a program that fails marks its block with the message, also far below`() {
        val text = (1..60).joinToString("") { "beep // $it\n" } + "var all = [1]\nvar i = 4\nshow all[i]\n"
        onTabletInBlocks(text) { workshop ->
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(40_000)
            pass(500)
            val failure = workshop.state.shownProgramRun.failure
            assertEquals(63, failure?.sourceLine)
            onNode(
                hasTestTag(ProgramTags.note(NoteKind.FAILURE)) and hasAnyAncestor(hasTestTag(ProgramTags.BLOCKS)),
            ).assertIsDisplayed()
            onNodeWithTag(workshop.tagOf(63)).assertIsDisplayed()
        }
    }

    @Test
    fun `a long program scrolls along with what runs`() {
        val text = (1..60).joinToString("") { "wait 0.1 seconds // $it\n" } + "beep\n"
        onTabletInBlocks(text) { workshop ->
            workshop.handle(ProgramEvent.BreakpointToggled(61))
            touch(RunTags.RUN)
            pass(9_000)
            assertEquals(61, workshop.runningLine)
            onNodeWithTag(workshop.tagOf(61)).assertIsDisplayed()
        }
    }

    private fun onLaptop(check: ComposeUiTest.(Workshop) -> Unit) = onScreen(1900, 1000, check)

    private val Workshop.runningLine get() = state.shownProgramRun.runningLine

    /** The tag of the block in [line], from 1. */
    private fun Workshop.tagOf(line: Int): String {
        val list = checkNotNull(state.programs.blocks).list
        return "block-" + list.rows[checkNotNull(list.rowOfLine(line - 1))].key
    }

    private fun ComposeUiTest.step(times: Int) = repeat(times) {
        touch(RunTags.STEP)
        pass(2_000)
    }

    private fun ComposeUiTest.step(kind: String) {
        touch(RunTags.STEPS)
        pass(300)
        touch(kind)
        pass(2_000)
    }

    /** What the block says about the run; null for nothing. */
    private fun ComposeUiTest.says(tag: String): String? =
        onNodeWithTag(tag).fetchSemanticsNode().config.getOrNull(SemanticsProperties.StateDescription)

    private fun ComposeUiTest.isLit(tag: String): Boolean {
        val pixels = pixelsOf(tag)
        return (0..<pixels.height step 4).any { y ->
            (0..<pixels.width step 4).any { x -> pixels[x, y] == RobotranColours.LIGHT.runningLine }
        }
    }

    private companion object {
        const val SOURCE = "var way = 2\nrepeat 3 times\n  forward way\n  way = way + 1\nend\nbeep\n"
        const val OWN = "procedure go()\n  forward 2\n  beep\nend\ngo()\ngo()\nbuzz\n"
        val PANES = listOf(ProgramTags.BLOCKS, ProgramTags.PROGRAM, ProgramTags.TRANSLATION_TEXT)
    }
}
