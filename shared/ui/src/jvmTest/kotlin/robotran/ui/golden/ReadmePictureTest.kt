package robotran.ui.golden

import kotlinx.coroutines.runBlocking
import robotran.projects.ProgramView
import robotran.ui.screen.photograph
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.openWorkshop
import kotlin.test.Test

/** The picture of README.md: the workshop on a tablet while the first program draws. */
class ReadmePictureTest {
    @Test
    fun `the page shows the workshop as it is`() {
        val workshop = runBlocking { openWorkshop() }
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(HALF_DRAWN)
        val picture = photograph(workshop, 1280, 800)
        workshop.close()
        GoldenPicture.checkPage("workshop", picture)
    }

    private companion object {
        /** Milliseconds into the square program: somewhere on its third side. */
        const val HALF_DRAWN = 3_900
    }
}
