package robotran.ui.learning

import kotlinx.coroutines.runBlocking
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.ui.programlanguages.ExampleSet
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.examples.examples
import robotran.workshop.openWorkshop
import robotran.workshop.state.LearningPage
import kotlin.test.Test

/** Pictures of the page with the examples. */
class ExamplesPictures {
    @Test
    fun `the examples of each language`() {
        for ((name, width, height) in listOf(Triple("tablet", 1280, 800), Triple("phone", 411, 891))) {
            val workshop = runBlocking { openWorkshop() }
            workshop.handle(LearningEvent.PageRequested(LearningPage.EXAMPLES))
            runBlocking {
                for (example in ProgramLanguage.ROBOLANG.examples.keys) {
                    ExamplePictures.of(
                        example,
                        SheetColours.LIGHT,
                        ROOM,
                    )
                }
            }
            photograph(workshop, width, height).keepAs("examples-$name")
            workshop.close()
        }
        for (set in listOf(ExampleSet.LEJOS, ExampleSet.NXJ)) {
            val workshop = runBlocking { openWorkshop(listOf(newJava())) }
            set.brick?.let { workshop.handle(WorldEditEvent.PenbotChosen(workshop.state.programs.shownRobot, it)) }
            workshop.handle(LearningEvent.PageRequested(LearningPage.EXAMPLES))
            runBlocking {
                for (name in set.programs.keys) ExamplePictures.of(set.idOf(name), SheetColours.LIGHT, ROOM)
            }
            photograph(workshop, 1280, 1600).keepAs("examples-java" + if (set == ExampleSet.NXJ) "-nxt" else "")
            workshop.close()
        }
    }

    private fun newJava() = Program.of("Square.java", ProgramLanguage.JAVA.examples.getValue("Square.java"))

    private companion object {
        val ROOM = PictureBounds.of(320, 240, density = 1f)
    }
}
