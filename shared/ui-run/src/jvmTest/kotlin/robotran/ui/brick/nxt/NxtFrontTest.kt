package robotran.ui.brick.nxt

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assert
import androidx.compose.ui.test.assertContentDescriptionContains
import androidx.compose.ui.test.assertContentDescriptionEquals
import androidx.compose.ui.test.assertHeightIsAtLeast
import androidx.compose.ui.test.assertWidthIsAtLeast
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.nxt.state.NxtState
import robotran.ui.brick.BrickFront
import robotran.ui.brick.BrickHint
import robotran.ui.brick.MIN_BRICK_WIDTH
import robotran.ui.language.InLanguage
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.undrawnTest
import robotran.ui.theme.RobotranTheme
import robotran.workshop.state.Settings
import robotran.world.FingerTouchPart
import kotlin.test.Test
import kotlin.test.assertEquals

@OptIn(ExperimentalTestApi::class)
class NxtFrontTest {
    private var state by mutableStateOf(NxtScenes.running)
    private val heard = mutableListOf<String>()
    private val robot = NxtScenes.robot.copy(
        parts = listOf(FingerTouchPart(1)) + NxtScenes.robot.parts.filter { (it.port ?: 0) > 2 },
    )

    private fun show(first: NxtState = NxtScenes.running, test: ComposeUiTest.() -> Unit) = undrawnTest(1024, 768) {
        state = first
        setContent {
            InLanguage(Language.ENGLISH) {
                RobotranTheme(false, Settings()) {
                    Column {
                        BrickFront(
                            state,
                            emptySet(),
                            { heard += "+$it" },
                            { heard += "-$it" },
                            Modifier.width(MIN_BRICK_WIDTH),
                            robot,
                        ) { port, pressed -> heard += "$port $pressed" }
                        BrickHint(state)
                    }
                }
            }
        }
        test()
    }

    @Test
    fun `a screen reader hears the lines of the display, the motors and the sensors`() = show {
        onNodeWithTag(RunTags.LCD).assertContentDescriptionEquals("Display: ${state.display.texts.joinToString("\n")}")
        onNodeWithTag(RunTags.port("A"))
            .assertContentDescriptionEquals("Motor A forward, power 75 percent, 1234 degrees")
        onNodeWithTag(RunTags.port("B")).assertContentDescriptionEquals("Motor B brakes, 0 degrees")
        onNodeWithTag(RunTags.port("C"))
            .assertContentDescriptionEquals("Motor C backward, power 60 percent, 1198 degrees")
        onNodeWithTag(RunTags.port(2)).assertContentDescriptionEquals("Sensor 2, nothing: 0")
        onNodeWithTag(RunTags.port(3)).assertContentDescriptionEquals("Sensor 3, light sensor: 57 %")
        onNodeWithTag(RunTags.port(4)).assertContentDescriptionEquals("Sensor 4, ultrasonic sensor: 45 cm")
    }

    @Test
    fun `while no program runs the ports show what their sensors measure, apart from a sonar, which is off`() =
        show(NxtScenes.idle) {
            onNodeWithTag(RunTags.port(1)).assertContentDescriptionContains(": 1", substring = true)
            onNodeWithTag(RunTags.port(2)).assertContentDescriptionEquals("Sensor 2, nothing")
            onNodeWithTag(RunTags.port(3)).assertContentDescriptionEquals("Sensor 3, light sensor: 57 %")
            onNodeWithTag(RunTags.port(4)).assertContentDescriptionEquals("Sensor 4, ultrasonic sensor")
        }

    @Test
    fun `a screen reader hears of a drawing that it is one`() = show(NxtScenes.drawing) {
        onNodeWithTag(RunTags.LCD).assertContentDescriptionEquals("Display: Face\na drawing")
    }

    @Test
    fun `a screen reader hears which entry of a menu is marked`() = show(NxtScenes.menu) {
        onNodeWithTag(RunTags.LCD).assertContentDescriptionContains("Display: Marked: Run Default", substring = true)
        state = state.copy(menu = state.menu?.copy(selected = 1))
        waitForIdle()
        mainClock.advanceTimeBy(600)
        onNodeWithTag(RunTags.LCD).assertContentDescriptionContains("Display: Marked: Files", substring = true)
    }

    @Test
    fun `a display that changes fast is read twice a second`() = show {
        mainClock.autoAdvance = false
        onNodeWithTag(RunTags.LCD).assert(
            SemanticsMatcher.expectValue(SemanticsProperties.LiveRegion, LiveRegionMode.Polite),
        )
        val spoken = mutableSetOf<String>()
        val shown = listOf(NxtScenes.menu, NxtScenes.loud, NxtScenes.failed).map { it.display }
        repeat(60) { frame ->
            state = NxtScenes.running.copy(display = shown[frame % shown.size])
            mainClock.advanceTimeBy(16)
            spoken +=
                onNodeWithTag(RunTags.LCD).fetchSemanticsNode().config[SemanticsProperties.ContentDescription].single()
        }
        assertEquals(true, spoken.size <= 3, "$spoken")
    }

    @Test
    fun `buttons are held until the finger leaves, and large enough for it`() = show {
        for (button in BrickKind.NXT.buttons) {
            val node = onNodeWithTag(RunTags.button(button))
            node.assertWidthIsAtLeast(48.dp).assertHeightIsAtLeast(48.dp)
            heard.clear()
            node.performTouchInput { down(center) }
            assertEquals(listOf("+$button"), heard)
            node.performTouchInput { up() }
            assertEquals(listOf("+$button", "-$button"), heard)
            node.performSemanticsAction(SemanticsActions.OnClick)
            assertEquals(listOf("+$button", "-$button", "+$button", "-$button"), heard)
        }
    }

    @Test
    fun `a touch sensor for fingers can be held, the others cannot`() = show {
        heard.clear()
        onNodeWithTag(RunTags.port(1)).assertWidthIsAtLeast(48.dp).assertHeightIsAtLeast(48.dp)
        onNodeWithTag(RunTags.port(1)).performTouchInput { down(center) }
        onNodeWithTag(RunTags.port(1)).performTouchInput { up() }
        onNodeWithTag(RunTags.port(4)).performTouchInput { down(center) }
        onNodeWithTag(RunTags.port(4)).performTouchInput { up() }
        assertEquals(listOf("0 true", "0 false"), heard)
    }

    @Test
    fun `an exception is told in words with the calls that led to it`() = show(NxtScenes.failed) {
        onNodeWithTag(RunTags.BRICK_HINT).assertExists()
        onNodeWithTag(RunTags.EXCEPTION_CALLS).assertExists()
        assertEquals(
            listOf("Exception: 5", "/ by zero"),
            state.display.texts.take(2),
        )
    }

    @Test
    fun `the strip shows the marked entry of the menu, or what is shown, or what has changed last`() {
        assertEquals(
            true,
            rowsToShow(NxtScenes.menu).contains(
                NxtScenes.menu.display.lines.indexOfFirst {
                    "Run" in it
                },
            ),
        )
        assertEquals(0..3, rowsToShow(NxtScenes.running))
        assertEquals(3..6, rowsToShow(NxtScenes.loud))
        val lines = NxtScenes.running.display.lines

        fun after(vararg changed: Int) =
            rowsAfter(0..3, lines.mapIndexed { row, line -> if (row in changed) "?" else line }, NxtScenes.running)
        assertEquals(0..3, after(2, 3))
        assertEquals(2..5, after(2, 5))
        assertEquals(4..7, after(0, 2, 7))
        assertEquals(0..3, after(6))
    }
}
