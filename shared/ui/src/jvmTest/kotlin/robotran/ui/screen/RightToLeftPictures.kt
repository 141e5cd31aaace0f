package robotran.ui.screen

import kotlinx.coroutines.runBlocking
import robotran.projects.ProgramView
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.openWorkshop
import kotlin.test.Test

/** Writes pictures of a lesson as a language that is read from right to left would have it, for review. */
class RightToLeftPictures {
    @Test
    fun `a lesson as text and in blocks, on a phone and on a tablet`() {
        for ((width, height) in listOf(411 to 891, 1280 to 800)) {
            for (view in listOf(ProgramView.TEXT, ProgramView.BLOCKS)) {
                val workshop = runBlocking { openWorkshop() }
                workshop.handle(BlockEvent.ViewChosen(view))
                workshop.handle(LearningEvent.TutorialStarted)
                photograph(workshop, width, height, isRightToLeft = true)
                    .keepAs("right-to-left/$width-${view.name.lowercase()}")
                workshop.close()
            }
        }
    }
}
