package robotran.ui.export

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.ui.school.tags.ExportTags
import robotran.ui.screen.Undrawn
import robotran.ui.screen.onEventThread
import robotran.ui.screen.pass
import robotran.ui.screen.pixelsOf
import robotran.ui.screen.undrawnTest
import robotran.ui.theme.RobotranTheme
import robotran.workshop.Workshop
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.FileKind
import robotran.workshop.state.ExportState
import robotran.workshop.state.MadePicture
import robotran.workshop.state.MadeWork
import robotran.workshop.state.Poster
import robotran.workshop.state.ShowError
import robotran.workshop.state.ShowStep
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals

@OptIn(ExperimentalTestApi::class)
class MadeViewTest {
    private val workshop = onEventThread { runBlocking { openWorkshop() } }

    @Test
    fun `a film plays once, and again at a touch`() = shown(ShowStep.Made(film())) {
        val early = picture()
        pass(2_000)
        val end = picture()
        assertNotEquals(early, end)
        pass(2_000)
        assertEquals(end, picture())
        onNodeWithTag(ExportTags.SHOW_MADE).performClick()
        pass(200)
        assertNotEquals(end, picture())
    }

    @Test
    fun `with less motion a film stands at its end until it is touched`() =
        shown(ShowStep.Made(film()), lessMotion = true) {
            val end = picture()
            pass(1_000)
            assertEquals(end, picture())
            onNodeWithTag(ExportTags.SHOW_MADE).performClick()
            pass(200)
            assertNotEquals(end, picture())
        }

    @Test
    fun `what was made can be shared and saved, and printed if it is a page`() {
        shown(ShowStep.Made(still()), canShare = true) {
            assertEquals(listOf(true, true, false, false), actions())
            onNodeWithTag(ExportTags.SHOW_SHARE).performClick()
            onNodeWithTag(ExportTags.SHOW_SAVE).performClick()
            onNodeWithTag(ExportTags.SHOW_MORE).performClick()
            assertEquals(
                listOf<WorkshopEvent>(
                    ExportEvent.ShareRequested,
                    ExportEvent.SaveRequested,
                    ExportEvent.BackRequested,
                ),
                events,
            )
        }
        shown(ShowStep.Made(poster())) { assertEquals(listOf(false, true, true, false), actions()) }
    }

    @Test
    fun `what became of it is said below it, and it stays in sight`() {
        shown(ShowStep.Made(still(), savedAs = "square.png")) {
            onNodeWithTag(ExportTags.SHOW_SAVED).assertTextEquals("Saved as square.png")
            onNodeWithTag(ExportTags.SHOW_MADE).assertIsDisplayed()
            assertEquals(listOf(false, true, false, true), actions())
        }
        shown(ShowStep.Made(still(), error = ShowError.NotShared)) {
            onNodeWithTag(ExportTags.SHOW_FAILED).assertIsDisplayed()
            onNodeWithTag(ExportTags.SHOW_MADE).assertIsDisplayed()
        }
    }

    private val events = mutableListOf<WorkshopEvent>()

    private fun shown(
        step: ShowStep,
        lessMotion: Boolean = false,
        canShare: Boolean = false,
        check: ComposeUiTest.() -> Unit,
    ) = undrawnTest(800, 700) {
        mainClock.autoAdvance = false
        events.clear()
        val state = ExportState(step, canRecord = true, canPrint = true, canShare = canShare, hasRun = true)
        setContent {
            RobotranTheme(dark = false, lessMotion = lessMotion) {
                Undrawn { ShowCard(state, world(), session(), { events += it }) }
            }
        }
        pass(50)
        check()
    }

    private fun still() = MadeWork("a.png", FileKind.PNG, ByteArray(0), MadePicture.Still(world(), session()))

    private fun film(): MadeWork {
        val states = onEventThread { workshop.statesOfRun() }
        return MadeWork("a.gif", FileKind.GIF, ByteArray(0), MadePicture.Moving(world(), states, FRAME))
    }

    private fun poster(): MadeWork {
        val poster = Poster("A", "", "", world(), session(), workshop.state.programs.program, Language.ENGLISH)
        return MadeWork("a.svg", FileKind.SVG, ByteArray(0), MadePicture.Page(poster))
    }

    private fun world() = workshop.state.run.world

    private fun session() = workshop.state.run.session

    private fun Workshop.statesOfRun() = List(FRAMES) {
        if (it == 0) handle(RunEvent.RunPressed) else advance(FRAME * 3)
        state.run.session
    }

    private fun ComposeUiTest.picture(): List<Int> = pixelsOf(ExportTags.SHOW_MADE).buffer.toList()

    /** Whether it can be shared, saved, printed and closed. */
    private fun ComposeUiTest.actions() =
        listOf(ExportTags.SHOW_SHARE, ExportTags.SHOW_SAVE, ExportTags.SHOW_PRINT, ExportTags.SHOW_CLOSE).map {
            onAllNodesWithTag(it).fetchSemanticsNodes().isNotEmpty()
        }

    private companion object {
        const val FRAME = 80
        const val FRAMES = 12
    }
}
