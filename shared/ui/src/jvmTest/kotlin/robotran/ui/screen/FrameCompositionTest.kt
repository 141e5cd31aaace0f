package robotran.ui.screen

import androidx.compose.runtime.Composer
import androidx.compose.runtime.CompositionTracer
import androidx.compose.runtime.InternalComposeTracingApi
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.ui.screen.tags.ScreenTags
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Pane
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** A frame of a run composes the rooms that show the run, and no other. */
@OptIn(ExperimentalTestApi::class, InternalComposeTracingApi::class)
class FrameCompositionTest {
    @Test
    fun `on a tablet a frame composes nothing of the program and the lessons`() = onTablet { workshop ->
        workshop.driveOn()
        pass(1_000)
        assertRoomsOfRun(composedIn { pass(500) })
    }

    @Test
    fun `on a tablet held upright neither`() = onScreen(800, 1280) { workshop ->
        workshop.driveOn()
        pass(1_000)
        assertRoomsOfRun(composedIn { pass(500) })
    }

    @Test
    fun `a program on a phone stands still in a frame`() = onPhone { workshop ->
        workshop.driveOn()
        onNodeWithTag(ScreenTags.tab(Pane.PROGRAM)).performClick()
        pass(1_000)
        val composed = composedIn { pass(500) }
        assertTrue(composed.any { it.startsWith("robotran.ui.runbar") }, "the run bar tells the time: $composed")
        assertEquals(emptyList(), composed.filter { it.startsWith("robotran.ui.program") })
    }

    /** A drive that takes longer than the test, with the tutorial beside it. */
    private fun Workshop.driveOn() {
        handle(LearningEvent.PageRequested(LearningPage.TUTORIAL))
        handle(ProgramEvent.ProgramEdited("forward 900"))
        handle(RunEvent.RunPressed)
    }

    private fun assertRoomsOfRun(composed: Set<String>) {
        assertTrue(composed.any { it.startsWith("robotran.ui.world") }, "the world is drawn: $composed")
        val others = listOf("program", "learning", "documents", "assignment", "course", "settings")
        assertEquals(emptyList(), composed.filter { name -> others.any { name.startsWith("robotran.ui.$it") } })
    }

    /** The composable functions that run while [act] does. */
    private fun composedIn(act: () -> Unit): Set<String> {
        val composed = mutableSetOf<String>()
        Composer.setTracer(object : CompositionTracer {
            override fun traceEventStart(key: Int, dirty1: Int, dirty2: Int, info: String) {
                composed += info.substringBefore(' ')
            }

            override fun traceEventEnd() = Unit

            override fun isTraceInProgress(): Boolean = true
        })
        try {
            act()
        } finally {
            Composer.setTracer(object : CompositionTracer {
                override fun traceEventStart(key: Int, dirty1: Int, dirty2: Int, info: String) = Unit

                override fun traceEventEnd() = Unit

                override fun isTraceInProgress(): Boolean = false
            })
        }
        return composed
    }
}
