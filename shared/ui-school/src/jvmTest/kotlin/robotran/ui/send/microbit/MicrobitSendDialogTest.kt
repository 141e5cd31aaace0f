package robotran.ui.send.microbit

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.semantics.ProgressBarRangeInfo
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTextInput
import robotran.language.Language
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.SendProgress
import robotran.ui.language.InLanguage
import robotran.ui.school.tags.SendTags
import robotran.ui.screen.Undrawn
import robotran.ui.screen.assertWhole
import robotran.ui.screen.isThere
import robotran.ui.screen.pass
import robotran.ui.screen.placesByTag
import robotran.ui.screen.undrawnTest
import robotran.ui.theme.RobotranTheme
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.state.MicrobitSendState
import robotran.workshop.state.MicrobitSendStep
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class MicrobitSendDialogTest {
    private var state: MicrobitSendState by mutableStateOf(MICROBIT_STEPS.getValue("building"))
    private val events = mutableListOf<MicrobitSendEvent>()

    @Test
    fun `the button that cancels is at one place in every step, on every screen, also with large text`() {
        for ((width, height) in SIZES) {
            for (textScale in listOf(1f, 2f)) {
                onSheet(width, height, Settings(language = Language.GERMAN, textScale = textScale)) {
                    val places = MICROBIT_STEPS.map { (name, next) ->
                        show(next)
                        assertWhole(SendTags.SEND_CANCEL, "$width x $height, $textScale: $name")
                    }
                    assertEquals(1, places.toSet().size, "$width x $height, $textScale: ${places.toSet()}")
                }
            }
        }
    }

    @Test
    fun `what a step offers can be pressed on every screen, also with text twice as large`() {
        for ((width, height) in SIZES) {
            for (textScale in listOf(1f, 2f)) {
                onSheet(width, height, Settings(language = Language.GERMAN, textScale = textScale)) {
                    for ((name, next) in MICROBIT_STEPS) {
                        show(next)
                        for (tag in ACTIONS intersect placesByTag().keys) {
                            // The ways are in a list that scrolls; everything else is always in sight.
                            if (next.step is MicrobitSendStep.Choosing) {
                                onNodeWithTag(tag).performSemanticsAction(SemanticsActions.OnClick)
                            } else {
                                assertWhole(tag, "$width x $height, $textScale: $name")
                                onNodeWithTag(tag).performClick()
                            }
                        }
                    }
                }
            }
        }
        val expected = setOf(
            MicrobitSendEvent.MicroPythonRequested,
            MicrobitSendEvent.HexSaved,
            MicrobitSendEvent.PythonSaved,
            MicrobitSendEvent.DriveRequested,
            MicrobitSendEvent.UsbRequested,
            MicrobitSendEvent.OtherBoardRequested,
            MicrobitSendEvent.Confirmed,
            MicrobitSendEvent.WholeRequested,
            MicrobitSendEvent.Retried,
            MicrobitSendEvent.BackRequested,
            MicrobitSendEvent.LineShown,
        )
        assertEquals(expected, events.toSet())
    }

    @Test
    fun `on a phone all ways onto a board are in sight`() = onSheet(411, 891, Settings(language = Language.GERMAN)) {
        for (name in listOf("first-usb", "choose-usb")) {
            show(MICROBIT_STEPS.getValue(name))
            for (tag in ACTIONS intersect placesByTag().keys) assertWhole(tag, name)
        }
    }

    @Test
    fun `the file that was chosen is named with its versions, and how full the board gets`() = onSheet(411, 891) {
        show(MICROBIT_STEPS.getValue("choose-all"))
        onNodeWithText("MicroPython for V1 (1.1.1), V2 (2.1.2), of the file microbit-program.hex.").assertExists()
        onNodeWithTag(SendTags.SEND_ROOM).assertTextContains("Your program fills 2,380 of 20,150 bytes.")
        show(MICROBIT_STEPS.getValue("first"))
        onNodeWithTag(SendTags.SEND_STEP).assertTextContains("First open a file with MicroPython", substring = true)
    }

    @Test
    fun `of several boards one is taken by a touch`() = onSheet(411, 891) {
        show(MICROBIT_STEPS.getValue("many"))
        onNodeWithTag(SendTags.board(1)).performClick()
        assertEquals(listOf<MicrobitSendEvent>(MicrobitSendEvent.BoardChosen(BOARDS[1])), events)
    }

    @Test
    fun `a file that was saved is followed by three steps, and the number on the board is explained`() =
        onSheet(411, 891) {
            show(MICROBIT_STEPS.getValue("saved"))
            for (step in 1..3) onNodeWithText("$step. ", substring = true).assertExists()
            onNodeWithTag(SendTags.SEND_NUMBER).performTextInput("529")
            assertEquals(MicrobitSendEvent.NumberEntered("529"), events.last())
            assertTrue(!isThere(SendTags.SEND_MEANING))
            show(MICROBIT_STEPS.getValue("number-${FlashErrorKind.OTHER_BOARD.name.lowercase()}"))
            onNodeWithTag(SendTags.SEND_MEANING).assertTextContains("for an older micro:bit", substring = true)
        }

    @Test
    fun `progress tells bytes, and that something was repeated`() = onSheet(411, 891) {
        show(MICROBIT_STEPS.getValue("sending"))
        onNodeWithTag(SendTags.SEND_BLOCK).assertTextContains("304,000 of 1,240,000 bytes")
        assertEquals(
            ProgressBarRangeInfo(304_000f / 1_240_000, 0f..1f),
            onNodeWithTag(SendTags.SEND_PROGRESS).fetchSemanticsNode().config[SemanticsProperties.ProgressBarRangeInfo],
        )
        assertTrue(!isThere(SendTags.SEND_WEAK))
        show(MICROBIT_STEPS.getValue("sending-again"))
        onNodeWithTag(SendTags.SEND_WEAK).assertIsDisplayed()
    }

    @Test
    fun `what the program prints is shown, and its error with the pupil's line`() = onSheet(411, 891) {
        show(MICROBIT_STEPS.getValue("running-prints"))
        onNodeWithText("and 35 lines before").assertExists()
        onNodeWithTag(SendTags.SEND_OUTPUT).assertTextContains("distance 273\ndist", substring = true)
        show(MICROBIT_STEPS.getValue("failed-at"))
        onNodeWithTag(SendTags.SEND_STEP).assertTextContains("divide by zero", substring = true)
        onNodeWithText("It happened at line 7.").assertExists()
    }

    @Test
    fun `a screen reader hears each step, and of a transfer only its quarters`() = onSheet(411, 891) {
        val heard = mutableListOf<String>()
        val sending = (0..40).map { MicrobitSendStep.Sending(SendProgress(it * 10, 400, attempt = 1), isWhole = false) }
        for (next in listOf(MicrobitSendStep.Connecting) + sending + MicrobitSendStep.Running()) {
            show(state.copy(step = next))
            val said = onNodeWithTag(SendTags.SEND_ANNOUNCER)
                .fetchSemanticsNode().config[SemanticsProperties.ContentDescription]
            if (said.single() != heard.lastOrNull()) heard += said.single()
        }
        assertEquals(
            listOf(
                "Connecting to the micro:bit.",
                "Your program is on its way to the micro:bit. That takes some seconds.",
                "25 percent sent",
                "50 percent sent",
                "75 percent sent",
                "100 percent sent",
                "Your program is on the micro:bit. Put the robot on the floor and press A.",
            ),
            heard,
        )
    }

    private fun ComposeUiTest.show(next: MicrobitSendState) {
        state = next
        pass(1)
    }

    private fun onSheet(
        width: Int,
        height: Int,
        settings: Settings = Settings(language = Language.ENGLISH),
        check: ComposeUiTest.() -> Unit,
    ) = undrawnTest(width, height) {
        mainClock.autoAdvance = false
        setContent {
            InLanguage(settings.language) {
                RobotranTheme(dark = false, settings) {
                    Undrawn { MicrobitSendDialog(state) { events += it } }
                }
            }
        }
        pass(100)
        check()
    }

    private companion object {
        val SIZES = listOf(411 to 891, 891 to 411, 1280 to 800)
        val ACTIONS = setOf(
            SendTags.SEND_AGAIN,
            SendTags.SEND_BACK,
            SendTags.SEND_CHOOSE_BOARD,
            SendTags.SEND_CHOOSE_MICROPYTHON,
            SendTags.SEND_CONFIRM,
            SendTags.SEND_DRIVE,
            SendTags.SEND_SAVE_HEX,
            SendTags.SEND_SAVE_PYTHON,
            SendTags.SEND_SHOW_LINE,
            SendTags.SEND_SHOW_MISTAKE,
            SendTags.SEND_USB,
            SendTags.SEND_WHOLE,
        )
    }
}
