package robotran.ui.program.blocks

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.hasAnyAncestor
import androidx.compose.ui.test.hasTestTag
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.projects.ProgramView
import robotran.robolang.words.BlockGroup
import robotran.ui.program.caret
import robotran.ui.program.keys
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.write
import robotran.ui.screen.assertWhole
import robotran.ui.screen.checkTargets
import robotran.ui.screen.isThere
import robotran.ui.screen.onPhone
import robotran.ui.screen.onScreen
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.scrollAndTouch
import robotran.ui.screen.scrollTo
import robotran.ui.screen.touch
import robotran.workshop.Workshop
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Pane
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests blocks and text side by side. */
@OptIn(ExperimentalTestApi::class)
class BlocksAndTextTest {
    private fun onAny(check: ComposeUiTest.(Workshop) -> Unit) {
        onTablet(check)
        onPhone(check)
        onLaptop(check)
    }

    /** Wide enough for blocks beside text. */
    private fun onLaptop(check: ComposeUiTest.(Workshop) -> Unit) = onScreen(2200, 1000, check)

    private fun ComposeUiTest.showBoth(workshop: Workshop, text: String) {
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        workshop.write(text, caret = 0)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BOTH))
        pass(300)
    }

    @Test
    fun `a touch on a block puts the caret into its line of the text`() = onAny { workshop ->
        showBoth(workshop, SOURCE)
        onNodeWithTag(ProgramTags.BLOCKS).assertIsDisplayed()
        onNodeWithTag(ProgramTags.PROGRAM).assertIsDisplayed()
        touchSignOf(ProgramTags.block("2"))
        assertEquals(SOURCE.indexOf("turn"), workshop.caret)
        touchSignOf(ProgramTags.block("0"))
        assertEquals(0, workshop.caret)
    }

    @Test
    fun `the caret of the text selects the block of its line`() = onAny { workshop ->
        showBoth(workshop, SOURCE)
        workshop.write(SOURCE, caret = SOURCE.indexOf("left"))
        pass(200)
        assertEquals("turn left 90", workshop.blockAtCursor)
        workshop.write(SOURCE.replace("beep", "buzz"), caret = SOURCE.indexOf("beep") + 4)
        pass(200)
        assertEquals("buzz", workshop.blockAtCursor)
    }

    @Test
    fun `below the blocks the text gives way to the sheet of a value and comes back`() = onPhone { workshop ->
        showBoth(workshop, SOURCE)
        touch(socketOf(SOURCE, "20"))
        assertEquals(0, onAllNodesWithTag(ProgramTags.PROGRAM).fetchSemanticsNodes().size)
        scrollAndTouch(ProgramTags.NUMBER_LESS)
        assertEquals(SOURCE.replace("20", "19"), workshop.text)
        touch(ProgramTags.BLOCK_SHEET_CLOSE)
        onNodeWithTag(ProgramTags.PROGRAM).assertIsDisplayed()
    }

    @Test
    fun `beside the blocks the text stays while a value is edited`() = onLaptop { workshop ->
        showBoth(workshop, SOURCE)
        touch(socketOf(SOURCE, "20"))
        onNodeWithTag(ProgramTags.PROGRAM).assertIsDisplayed()
        assertTrue(workshop.caret in SOURCE.indexOf("forward")..SOURCE.indexOf("20"), "${workshop.caret}")
    }

    @Test
    fun `both views have room for work on tablets and phones, side by side or one above the other`() {
        for ((size, isBeside) in listOf(
            (1280 to 800) to true,
            (1440 to 900) to true,
            (820 to 1180) to true,
            (800 to 1280) to true,
            (891 to 411) to true,
            (360 to 640) to false,
            (411 to 891) to false,
        )) {
            onScreen(size.first, size.second) { workshop ->
                showBoth(workshop, "$SOURCE\nforwrd 5\n")
                val blocks = placeOf(ProgramTags.BLOCK_PANE)
                val text = placeOf(ProgramTags.PROGRAM)
                assertEquals(isBeside, text.left >= blocks.right, "$size: $blocks, $text")
                assertTrue(blocks.width >= 320f && text.width >= 300f, "$size: $blocks, $text")
                assertTrue(blocks.height >= 138f && text.height >= 120f, "$size: $blocks, $text")
                val adding = ProgramTags.BLOCKS_ADD
                val add = if (isThere(adding)) adding else ProgramTags.group(BlockGroup.DRIVE)
                checkTargets(add)
                touch(add)
                scrollTo(ProgramTags.take("move"))
                assertWhole(ProgramTags.take("move"), "$size")
            }
        }
    }

    @Test
    fun `a mistake can be fixed in the blocks and in the text`() {
        val inBlocks = hasAnyAncestor(hasTestTag(ProgramTags.BLOCKS))
        for (view in listOf(inBlocks, !inBlocks)) {
            onLaptop { workshop ->
                showBoth(workshop, "beep\nforwrd 20\n")
                onNode(hasTestTag(ProgramTags.FIX) and view).performClick()
                pass(300)
                assertEquals("beep\nforward 20\n", workshop.text, view.description)
            }
        }
    }

    @Test
    fun `a block has help on its word`() = onTabletInBlocks(SOURCE) { workshop ->
        touch(ProgramTags.block("1"))
        touch(ProgramTags.BLOCK_MORE)
        scrollAndTouch(ProgramTags.action(ProgramTags.HELP))
        assertEquals(LearningPage.HELP, workshop.state.learning.page)
        assertTrue(workshop.state.learning.help.word.orEmpty().startsWith("forward"), "${workshop.state.learning.help}")
    }

    @Test
    fun `F1 is help on the block that the keyboard is at`() = onTabletInBlocks(SOURCE) { workshop ->
        touch(ProgramTags.block("2"))
        focusBlocks()
        keys(listOf(Key.F1))
        pass(200)
        assertEquals("turn", workshop.state.learning.help.word)
    }

    private val Workshop.blockAtCursor: String?
        get() = state.programs.blocks?.let { blocks ->
            blocks.cursor?.let { blocks.program[it.block] }?.head?.span?.textIn(text)?.trim()
        }

    private companion object {
        const val SOURCE = "pen down\nforward 20\nturn left 90\nbeep\n"
    }
}
