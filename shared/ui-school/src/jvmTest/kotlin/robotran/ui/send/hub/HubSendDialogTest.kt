package robotran.ui.send.hub

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.semantics.ProgressBarRangeInfo
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import robotran.brick.kind.BrickKind
import robotran.hublink.DownloadProgress
import robotran.hublink.connection.HubTransport
import robotran.language.Language
import robotran.ui.common.tags.CommonTags
import robotran.ui.language.InLanguage
import robotran.ui.program.pressTool
import robotran.ui.school.tags.SendTags
import robotran.ui.screen.Undrawn
import robotran.ui.screen.assertWhole
import robotran.ui.screen.isThere
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.placesByTag
import robotran.ui.screen.undrawnTest
import robotran.ui.theme.RobotranTheme
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HubSendEvent
import robotran.workshop.state.HubSendState
import robotran.workshop.state.HubSendStep
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class HubSendDialogTest {
    private var state: HubSendState by mutableStateOf(HUB_STEPS.getValue("building"))
    private val events = mutableListOf<HubSendEvent>()

    @Test
    fun `the button that cancels is at one place in every step, on every screen, also with large text`() {
        for ((width, height) in SIZES) {
            for (textScale in listOf(1f, 2f)) {
                onSheet(width, height, Settings(language = Language.GERMAN, textScale = textScale)) {
                    val places = HUB_STEPS.map { (name, next) ->
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
                    for ((name, next) in HUB_STEPS) {
                        show(next)
                        for (tag in ACTIONS intersect placesByTag().keys) {
                            assertWhole(tag, "$width x $height, $textScale: $name")
                            onNodeWithTag(tag).performClick()
                        }
                    }
                }
            }
        }
        val expected = setOf(
            HubSendEvent.Retried,
            HubSendEvent.OtherHubRequested,
            HubSendEvent.Confirmed,
            HubSendEvent.Started,
            HubSendEvent.Stopped,
            HubSendEvent.PythonSaved,
            HubSendEvent.LineShown,
        )
        assertEquals(expected, events.toSet())
    }

    @Test
    fun `whether a program tells its lines is switched before it is sent, and when it is in the hub`() =
        onSheet(411, 891) {
            for (name in listOf("found", "found-low", "ready")) {
                show(HUB_STEPS.getValue(name))
                assertWhole(SendTags.SEND_LINE_SWITCH, name)
                onNodeWithTag(SendTags.SEND_LINE_SWITCH).performClick()
            }
            assertEquals<List<HubSendEvent>>(List(3) { HubSendEvent.LineSwitched(isOn = false) }, events)
        }

    @Test
    fun `a hub in the list is chosen by a touch, and hubs are looked for by each transport`() = onSheet(411, 891) {
        show(HubSendStep.Choosing(listOf(ADA, CABLE), HubTransport.entries))
        onNodeWithText("Ada, by Bluetooth").assertExists()
        onNodeWithTag(SendTags.hub(1)).performClick()
        show(HubSendStep.Choosing(emptyList(), HubTransport.entries))
        for (transport in HubTransport.entries) onNodeWithTag(SendTags.look(transport)).performClick()
        assertEquals(
            listOf(HubSendEvent.HubChosen(CABLE)) + HubTransport.entries.map { HubSendEvent.TransportRequested(it) },
            events,
        )
    }

    @Test
    fun `a hub that is found is named with its firmware and room, and another one is told`() = onSheet(411, 891) {
        show(HUB_STEPS.getValue("found"))
        onNodeWithText("This hub answers: Ada, SPIKE Prime. Is it yours?").assertExists()
        onNodeWithText("It has Pybricks 4.0.1 and room for programs of 261,000 bytes.").assertExists()
        show(HUB_STEPS.getValue("found-other"))
        onNodeWithTag(SendTags.SEND_STEP).assertTextContains("Your program is for SPIKE Prime", substring = true)
    }

    @Test
    fun `the causes of a hub that is not in the list stand below each other`() = onSheet(411, 891) {
        show(HUB_STEPS.getValue("choose-missing"))
        onNodeWithText(
            "Does a program run on it? Stop it with the hub's button: until then the hub hides.",
        ).assertExists()
        onNodeWithText("Is it near? Put it within two metres.").assertExists()
    }

    @Test
    fun `progress tells bytes, and that something was repeated`() = onSheet(411, 891) {
        show(HUB_STEPS.getValue("sending"))
        onNodeWithTag(SendTags.SEND_BLOCK).assertTextContains("1,504 of 2,380 bytes")
        assertEquals(
            ProgressBarRangeInfo(1504f / 2380, 0f..1f),
            onNodeWithTag(SendTags.SEND_PROGRESS).fetchSemanticsNode().config[SemanticsProperties.ProgressBarRangeInfo],
        )
        assertTrue(!isThere(SendTags.SEND_WEAK))
        show(HUB_STEPS.getValue("sending-again"))
        onNodeWithTag(SendTags.SEND_WEAK).assertIsDisplayed()
    }

    @Test
    fun `a program that runs shows its line and the end of what it prints, later all of it`() = onSheet(411, 891) {
        show(HUB_STEPS.getValue("running-prints"))
        onNodeWithTag(SendTags.SEND_STEP).assertTextContains("line 4", substring = true)
        onNodeWithText("and 35 lines before").assertExists()
        onNodeWithTag(SendTags.SEND_OUTPUT).assertTextContains("distance 273\ndist", substring = true)
        show(HUB_STEPS.getValue("stopped"))
        onNodeWithTag(SendTags.SEND_OUTPUT).assertTextContains("distance 0\ndistance 7", substring = true)
    }

    @Test
    fun `a missing motor is told with its port and the line of the program`() = onSheet(411, 891) {
        show(HUB_STEPS.getValue("ended-missing_device"))
        onNodeWithTag(SendTags.SEND_STEP).assertTextContains("port D", substring = true)
        onNodeWithText("It happened at line 7.").assertExists()
    }

    @Test
    fun `a screen reader hears each step, and of a transfer only its quarters`() = onSheet(411, 891) {
        val heard = mutableListOf<String>()
        val sending = (0..40).map { HubSendStep.Sending(DownloadProgress(it * 10, 400, attempt = 1)) }
        for (next in listOf(HubSendStep.Connecting) + sending + HubSendStep.Ready(400)) {
            show(next)
            val said = onNodeWithTag(SendTags.SEND_ANNOUNCER)
                .fetchSemanticsNode().config[SemanticsProperties.ContentDescription]
            if (said.single() != heard.lastOrNull()) heard += said.single()
        }
        assertEquals(
            listOf(
                "Connecting to the hub.",
                "Your program is on its way to Ada.",
                "25 percent sent",
                "50 percent sent",
                "75 percent sent",
                "100 percent sent",
                "Your program is in the hub. Give the robot room, then start it here or with the hub's button.",
            ),
            heard,
        )
    }

    @Test
    fun `the sheet opens from the tools of a program for a hub, and offers Python where no hub is reached`() =
        onTablet { workshop ->
            workshop.handle(DocumentEvent.NewWithBrick(BrickKind.SPIKE_PRIME))
            pass(1_000)
            pressTool(CommonTags.SEND_ROBOT)
            pass(5_000)
            onNodeWithTag(SendTags.SEND_SAVE_PYTHON).assertIsDisplayed()
            onNodeWithTag(SendTags.SEND_CANCEL).performClick()
            pass(500)
            assertTrue(!isThere(SendTags.SEND_SHEET))
        }

    private fun ComposeUiTest.show(next: HubSendStep) = show(HubSendState("square.robo", next, HUB))

    private fun ComposeUiTest.show(next: HubSendState) {
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
                    Undrawn { HubSendDialog(state) { events += it } }
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
            SendTags.SEND_OTHER_HUB,
            SendTags.SEND_SHOW_MISTAKE,
            SendTags.SEND_SHOW_LINE,
            SendTags.SEND_CONFIRM,
            SendTags.SEND_SAVE_PYTHON,
            SendTags.SEND_START,
            SendTags.SEND_STOP,
        )
    }
}
