package robotran.ui.world

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertContentDescriptionContains
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.click
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.requestFocus
import androidx.compose.ui.test.swipe
import androidx.compose.ui.test.withKeyDown
import robotran.ui.world.tags.WorldTags
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.SheetWords
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class WordsOnSheetTest {
    @Test
    fun `the menu of the view tells where the robot is, and a button closes it`() = onSheet {
        onNodeWithTag(WorldTags.SHEET_SHOW).performClick()
        settle()
        onNodeWithTag(WorldTags.ofMenu(WorldTags.WHERE_AM_I)).performClick()
        settle()
        assertSaid("The robot \"yellow\" is 30 cm from the left, 40 cm up.")
        assertSaid("To the edge of the sheet: 61 cm ahead, ")
        assertSaid("The robot \"red\" is 54 cm away, 22 degrees to the left.")
        assertSaid("Its middle is 63 cm away, 18 degrees to the right.")
        onNodeWithTag(WorldTags.CLOSE_WORDS).performClick()
        settle()
        onNodeWithTag(WorldTags.WORDS).assertDoesNotExist()
        assertEquals("", said)
    }

    @Test
    fun `F8 tells it with any focus, once more if it is pressed again, and Escape closes it`() = onSheet {
        sheet.requestFocus()
        press(Key.F8)
        assertSaid("It looks to the right.")
        val first = said
        press(Key.F8)
        assertTrue(said != first && said.trim() == first.trim(), "It would not be said again: $said")
        press(Key.Escape)
        assertNull(workshop.state.sheet.words)
    }

    @Test
    fun `a screen reader asks at the sheet and hears it in a polite live region`() = onSheet {
        val actions = sheet.fetchSemanticsNode().config[SemanticsActions.CustomActions]
        assertEquals(listOf("Where am I?", "Explore the sheet", "What happened?"), actions.map { it.label })
        assertTrue(actions.first().action())
        settle()
        assertSaid("The pen is up.")
        val region = onNodeWithTag(WorldTags.WORDS_SAID).fetchSemanticsNode().config
        assertEquals(LiveRegionMode.Polite, region[SemanticsProperties.LiveRegion])
    }

    @Test
    fun `arrows move the cross and say what is there, Escape puts it away`() = onSheet {
        explore()
        assertEquals(Point(30.0, 40.0), cross)
        assertSaid("30 cm from the left, 40 cm up: the robot \"yellow\".")
        onNodeWithTag(WorldTags.EXPLORING_CROSS).assertIsFocused()
        onNodeWithTag(WorldTags.EXPLORING_CROSS).performKeyInput {
            repeat(6) { pressKey(Key.DirectionRight) }
            withKeyDown(Key.ShiftLeft) { pressKey(Key.DirectionUp) }
            repeat(2) { pressKey(Key.DirectionDown) }
        }
        settle()
        assertEquals(Point(60.0, 31.0), cross)
        assertSaid("60 cm from the left, 31 cm up: a block.")
        onNodeWithTag(WorldTags.EXPLORING_CROSS).assertContentDescriptionContains("a block", substring = true)
        onNodeWithTag(WorldTags.EXPLORING_CROSS).performKeyInput { pressKey(Key.Escape) }
        settle()
        assertNull(workshop.state.sheet.words)
        sheet.assertIsFocused()
        assertTrue(workshop.inputs.isEmpty(), "${workshop.inputs}")
    }

    @Test
    fun `a finger moves the cross and nothing else`() = onSheet {
        explore()
        sheet.performTouchInput { click(at(60.0, 10.0)) }
        settle()
        assertSaid("a barrier.")
        sheet.performTouchInput { swipe(at(30.0, 40.0), at(20.0, 66.0), 200) }
        settle()
        assertEquals(20.0, cross.x, 0.5)
        assertSaid("In the light of a lamp.")
        assertTrue(workshop.inputs.isEmpty(), "${workshop.inputs}")
    }

    @Test
    fun `with the setting a run is told when it ends, and a button tells where the robot is`() = onSheet {
        workshop.handle(SettingsEvent.SettingsChanged(workshop.state.settings.copy(tellsRuns = true)))
        settle()
        onNodeWithTag(WorldTags.ofControls(WorldTags.WHERE_AM_I)).performClick()
        settle()
        assertIs<SheetWords.WhereIs>(workshop.state.sheet.words)
        run()
        assertIs<SheetWords.Told>(workshop.state.sheet.words)
        assertSaid("The robot \"yellow\" ")
        assertSaid("The program ended at ")
    }

    @Test
    fun `without it, a run is told when it is asked for, and from then on`() = onSheet {
        run()
        assertNull(workshop.state.sheet.words)
        sheet.requestFocus()
        sheet.performKeyInput { withKeyDown(Key.CtrlLeft) { pressKey(Key.F8) } }
        settle()
        assertSaid("The program ended at ")
        press(Key.Escape)
        assertNull(workshop.state.sheet.words)
        run()
        assertSaid("The program ended at ")
    }

    private val SheetOnScreen.said: String
        get() = onNodeWithTag(WorldTags.WORDS_SAID).fetchSemanticsNode().config[SemanticsProperties.ContentDescription]
            .single()

    private val SheetOnScreen.cross: Point get() = assertIs<SheetWords.Explored>(workshop.state.sheet.words).place

    private fun SheetOnScreen.assertSaid(words: String) = assertTrue(words in said, "$words was not said: $said")

    private fun SheetOnScreen.press(key: Key) {
        sheet.performKeyInput { pressKey(key) }
        settle()
    }

    private fun SheetOnScreen.explore() {
        sheet.requestFocus()
        sheet.performKeyInput { withKeyDown(Key.ShiftLeft) { pressKey(Key.F8) } }
        settle()
    }

    private fun SheetOnScreen.run() {
        workshop.handle(RunEvent.RunPressed)
        pass(300)
        repeat(70) {
            workshop.advance(1_000)
            if (!workshop.state.running) return@repeat
        }
        settle()
    }
}
