package robotran.ui.world

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.learning.WorldGallery
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.Settings
import kotlin.test.Test

/** Pictures of the card with the task of a world. */
class TaskCardPictures {
    @Test
    fun `the task of a world of one's own`() {
        for ((name, size) in screens) {
            for (scale in listOf(1f, 2f)) {
                val workshop = runBlocking { openWorkshop() }
                workshop.handle(SettingsEvent.SettingsChanged(Settings(textScale = scale)))
                workshop.services.editor.changeWorld(
                    workshop.state.world.copy(title = "Corner", task = TASK),
                    isAnother = true,
                )
                photograph(workshop, size.first, size.second, dark = scale == 2f).keepAs("task-$name-${scale.toInt()}")
                workshop.close()
            }
        }
    }

    @Test
    fun `the task of a world of the gallery`() {
        for ((name, size) in screens) {
            for (scale in listOf(1f, 2f)) {
                val workshop = runBlocking { openWorkshop() }
                workshop.handle(
                    SettingsEvent.SettingsChanged(Settings(textScale = scale, language = Language.GERMAN)),
                )
                workshop.handle(LearningEvent.WorldChosen("square"))
                workshop.draw("$name-${scale.toInt()}", size, dark = scale == 2f)
                workshop.tries(task.solution.text.replace("left", "right"))
                workshop.draw("$name-${scale.toInt()}-missing", size, dark = scale == 2f)
                workshop.handle(ScreenEvent.TaskShown(true))
                workshop.draw("$name-${scale.toInt()}-hint", size, dark = scale == 2f)
                workshop.tries(task.solution.text)
                workshop.draw("$name-${scale.toInt()}-solved", size, dark = scale == 2f)
                workshop.close()
            }
        }
    }

    private fun Workshop.draw(name: String, size: Pair<Int, Int>, dark: Boolean) =
        photograph(this, size.first, size.second, dark).keepAs("world-task/$name")

    private fun Workshop.tries(program: String) {
        handle(ProgramEvent.ProgramEdited(program))
        handle(RunEvent.RunPressed)
        advance(30_000)
    }

    private companion object {
        val screens = mapOf("phone" to (411 to 891), "phone-on-its-side" to (891 to 411), "tablet" to (1280 to 800))
        const val TASK = "Drive to the flag in the upper corner.\nLift the pen on the way.\nBeep when you are there."
        val task = checkNotNull(checkNotNull(WorldGallery.named("square")).lesson)
    }
}
