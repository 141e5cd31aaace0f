package robotran.ui.send

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.semantics.ProgressBarRangeInfo
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import robotran.language.Language
import robotran.tower.Remains
import robotran.tower.TowerError
import robotran.tower.TransferProgress
import robotran.tower.port.TowerKind
import robotran.ui.common.tags.CommonTags
import robotran.ui.language.InLanguage
import robotran.ui.program.pressTool
import robotran.ui.program.tags.ProgramTags
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.tags.SendTags
import robotran.ui.screen.Undrawn
import robotran.ui.screen.assertWhole
import robotran.ui.screen.isThere
import robotran.ui.screen.onPhone
import robotran.ui.screen.onScreen
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.placesByTag
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.undrawnTest
import robotran.ui.theme.RobotranTheme
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.send.USB_TOWER
import robotran.workshop.state.Pane
import robotran.workshop.state.SendError
import robotran.workshop.state.SendState
import robotran.workshop.state.SendStep
import robotran.workshop.state.Settings
import robotran.workshop.state.Transfer
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class SendDialogTest {
    private var step: SendStep by mutableStateOf(SendStep.Building)
    private val events = mutableListOf<SendEvent>()

    @Test
    fun `the button that cancels is at one place in every step, on every screen, also with large text`() {
        for ((width, height) in SIZES) {
            for (textScale in listOf(1f, 2f)) {
                onSheet(width, height, Settings(language = Language.GERMAN, textScale = textScale)) {
                    val places = SEND_STEPS.map { (name, next) ->
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
                    for ((name, next) in SEND_STEPS) {
                        show(next)
                        for (tag in ACTIONS intersect placesByTag().keys) {
                            assertWhole(tag, "$width x $height, $textScale: $name")
                            onNodeWithTag(tag).performClick()
                        }
                    }
                }
            }
        }
        val pressed = events.toSet()
        val expected = setOf(
            SendEvent.Retried,
            SendEvent.OtherTowerRequested,
            SendEvent.DiagnosticShown,
            SendEvent.FirmwareFileRequested,
            SendEvent.FirmwareConfirmed,
            SendEvent.WatchingRequested,
            SendEvent.SlotsEmptied,
            SendEvent.DatalogRequested,
            SendEvent.DatalogSaved,
        )
        assertEquals(expected, pressed)
    }

    @Test
    fun `a tower in the list is chosen by a touch, and a kind of tower is looked for`() = onSheet(411, 891) {
        show(SendStep.ChoosingTower(listOf(USB_TOWER), TowerKind.entries))
        onNodeWithTag(SendTags.tower(0)).performClick()
        onNodeWithTag(SendTags.look(TowerKind.SERIAL)).performClick()
        onNodeWithTag(SendTags.look(TowerKind.USB)).performClick()
        assertEquals(
            listOf(
                SendEvent.TowerChosen(USB_TOWER),
                SendEvent.TowerRequested(TowerKind.SERIAL),
                SendEvent.TowerRequested(TowerKind.USB),
            ),
            events,
        )
    }

    @Test
    fun `a slot is chosen by a touch, and the last one is named`() = onSheet(411, 891) {
        show(SendStep.ChoosingSlot(last = 2))
        onNodeWithContentDescription("Slot 2, as last time").assertExists()
        onNodeWithContentDescription("Slot 5").assertExists()
        for (slot in 1..5) {
            assertWhole(SendTags.slot(slot), "a phone")
            onNodeWithTag(SendTags.slot(slot)).performClick()
        }
        assertEquals((1..5).map { SendEvent.SlotChosen(it) }, events.toList<SendEvent>())
    }

    @Test
    fun `the first values of a datalog are listed with what they are from`() = onSheet(411, 891) {
        show(SEND_STEPS.getValue("datalog"))
        val lines = listOf(
            "75 values from the datalog of your robot:",
            "1: sensor 1 is 192",
            "2: timer 1 is 96",
            "3: variable 31 is 93",
            "4: clock is 384",
            "5: kind 153 is 459",
            "6: sensor 2 is 40",
            "and 25 more",
        )
        for (line in lines) onNodeWithText(line).assertExists()
        show(SEND_STEPS.getValue("datalog-reading"))
        onNodeWithTag(SendTags.SEND_BLOCK).assertTextContains("50 of 123 values, about 5 s left")
    }

    @Test
    fun `what the brick has after a fault is told`() = onSheet(411, 891) {
        show(SendStep.Failed(SendError.OfTower(TowerError.TowerGone), Remains.NO_PROGRAM, slot = 5))
        onNodeWithText("Slot 5 of the robot is empty now. The other slots are as before.").assertExists()
        show(SendStep.Failed(SendError.OfTower(TowerError.TowerGone), Remains.NO_FIRMWARE))
        onNodeWithText("The brick has no firmware now. Nothing is broken: send it again.").assertExists()
    }

    @Test
    fun `progress tells blocks and time left, and that tower and brick see each other badly`() = onSheet(411, 891) {
        show(sending(confirmed = 7, secondsLeft = 33))
        onNodeWithTag(SendTags.SEND_BLOCK).assertTextContains("Block 7 of 28, about 35 s left")
        assertEquals(
            ProgressBarRangeInfo(0.25f, 0f..1f),
            onNodeWithTag(SendTags.SEND_PROGRESS).fetchSemanticsNode().config[SemanticsProperties.ProgressBarRangeInfo],
        )
        assertTrue(!isThere(SendTags.SEND_WEAK))
        show(sending(confirmed = 7, secondsLeft = 133, repeats = 6))
        onNodeWithTag(SendTags.SEND_BLOCK).assertTextContains("Block 7 of 28, about 3 min left")
        onNodeWithTag(SendTags.SEND_WEAK).assertIsDisplayed()
    }

    @Test
    fun `a screen reader hears each step, and of a transfer only its quarters`() = onSheet(411, 891) {
        val heard = mutableListOf<String>()
        for (next in listOf(SendStep.Checking) + (0..28).map { sending(it, 40) } + SendStep.Done(100)) {
            show(next)
            val said = onNodeWithTag(SendTags.SEND_ANNOUNCER)
                .fetchSemanticsNode().config[SemanticsProperties.ContentDescription]
            if (said.single() != heard.lastOrNull()) heard += said.single()
        }
        assertEquals(
            listOf(
                "Looking for your robot.",
                "Your program is on its way to the robot.",
                "25 percent sent",
                "50 percent sent",
                "75 percent sent",
                "100 percent sent",
                "Your program is in the robot. Press Run on your robot.",
            ),
            heard,
        )
    }

    @Test
    fun `messages are listed with the newest first`() = onSheet(411, 891) {
        show(SEND_STEPS.getValue("watching-messages"))
        val newer = onNodeWithText("12.0 s: bytes 18 5 0 255").fetchSemanticsNode().boundsInRoot
        val older = onNodeWithText("1.2 s: message 5").fetchSemanticsNode().boundsInRoot
        onNodeWithText("2.9 s: message 200").assertExists()
        assertTrue(newer.bottom <= older.top)
    }

    @Test
    fun `the sheet opens from the program's tools and says where towers can be reached`() = onTablet {
        pressTool(CommonTags.SEND_ROBOT)
        pass(5_000)
        onNodeWithTag(SendTags.SEND_SHEET).assertIsDisplayed()
        onNodeWithTag(SendTags.SEND_CANCEL).performClick()
        pass(500)
        assertTrue(!isThere(SendTags.SEND_SHEET))
    }

    @Test
    fun `on a phone the sheet opens from the program and from the menu`() = onPhone { workshop ->
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        pass(300)
        pressTool(CommonTags.SEND_ROBOT)
        pass(1_000)
        onNodeWithTag(SendTags.SEND_CANCEL).performClick()
        pass(500)
        onNodeWithTag(ScreenTags.MENU).performClick()
        pass(500)
        onNodeWithTag(DocumentTags.WORK_MENU).performClick()
        pass(500)
        onNodeWithTag(DocumentTags.menuItem(CommonTags.SEND_ROBOT)).performClick()
        pass(1_000)
        onNodeWithTag(SendTags.SEND_SHEET).assertIsDisplayed()
    }

    @Test
    fun `where the row of tools is too narrow for its button, the sheet opens from the menu of the tools`() =
        onScreen(1024, 768) { workshop ->
            workshop.handle(ProgramEvent.ProgramEdited("forward 5\n"))
            pass(1_000)
            assertWhole(ProgramTags.EDITOR_MORE, "a small tablet across")
            assertTrue(!isThere(CommonTags.SEND_ROBOT))
            onNodeWithTag(ProgramTags.EDITOR_MORE).performClick()
            pass(500)
            onNodeWithTag(CommonTags.SEND_ROBOT).performClick()
            pass(1_000)
            onNodeWithTag(SendTags.SEND_SHEET).assertIsDisplayed()
        }

    private fun sending(confirmed: Int, secondsLeft: Int, repeats: Int = 0) =
        SendStep.Sending(Transfer.PROGRAM, TransferProgress(confirmed, totalBlocks = 28, repeats, secondsLeft))

    private fun ComposeUiTest.show(next: SendStep) {
        step = next
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
                    Undrawn { SendDialog(SendState("square.robo", step)) { events += it } }
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
            SendTags.SEND_OTHER_TOWER,
            SendTags.SEND_SHOW_MISTAKE,
            SendTags.SEND_CHOOSE_FIRMWARE,
            SendTags.SEND_FIRMWARE,
            SendTags.SEND_WATCH,
            SendTags.SEND_EMPTY_SLOTS,
            SendTags.SEND_READ_DATALOG,
            SendTags.SEND_SAVE_DATALOG,
            SendTags.SEND_TO_SLOTS,
        )
    }
}
