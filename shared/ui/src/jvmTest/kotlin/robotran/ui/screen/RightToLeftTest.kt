package robotran.ui.screen

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import kotlinx.coroutines.runBlocking
import robotran.projects.ProgramView
import robotran.ui.RobotranApp
import robotran.workshop.Workshop
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.openWorkshop
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertTrue

/** The app in a made-up language that is read from right to left: in English words, laid out the other way round. */
@OptIn(ExperimentalTestApi::class)
class RightToLeftTest {
    @Test
    fun `everything that can be touched is on the other side, and nothing is outside of the window`() {
        for ((width, height) in listOf(411 to 891, 800 to 1280, 1280 to 800)) {
            for (view in listOf(ProgramView.TEXT, ProgramView.BLOCKS)) {
                val fromLeft = placesOf(width, height, view, isRightToLeft = false)
                val fromRight = placesOf(width, height, view, isRightToLeft = true)
                val both = fromLeft.keys intersect fromRight.keys
                assertTrue(both.size > ENOUGH, "$width x $height: ${both.size}")
                val outside = fromRight.filterValues { it.left < -1 || it.right > width + 1 }
                assertTrue(outside.isEmpty(), "outside of $width x $height: $outside")
                val mirrored = both.filter { isMirrored(fromLeft.getValue(it), fromRight.getValue(it), width) }
                assertTrue(mirrored.size >= both.size * MOST, "$width x $height $view: only $mirrored of $both")
            }
        }
    }

    private fun placesOf(width: Int, height: Int, view: ProgramView, isRightToLeft: Boolean): Map<String, Rect> {
        val workshop = newWorkshop(view)
        val places = mutableMapOf<String, Rect>()
        try {
            undrawnTest(width, height) {
                mainClock.autoAdvance = false
                setContent { Undrawn { RobotranApp(workshop, false, isRightToLeft = isRightToLeft) } }
                pass(SETTLE)
                val touched = SemanticsMatcher.keyIsDefined(SemanticsActions.OnClick)
                for (node in onAllNodes(touched, useUnmergedTree = true).fetchSemanticsNodes()) {
                    val tag = node.config.getOrNull(SemanticsProperties.TestTag) ?: continue
                    places[tag] = node.boundsInRoot
                }
            }
        } finally {
            workshop.close()
        }
        return places
    }

    private fun newWorkshop(view: ProgramView): Workshop = runBlocking { openWorkshop() }.apply {
        handle(BlockEvent.ViewChosen(view))
        handle(LearningEvent.TutorialStarted)
    }

    private fun isMirrored(fromLeft: Rect, fromRight: Rect, width: Int): Boolean =
        abs(fromLeft.center.x + fromRight.center.x - width) < NEAR

    private companion object {
        const val SETTLE = 600L
        const val ENOUGH = 12

        /** What shows the world is the same in every language, such as the buttons of its zoom. */
        const val MOST = 0.75
        const val NEAR = 6f
    }
}
