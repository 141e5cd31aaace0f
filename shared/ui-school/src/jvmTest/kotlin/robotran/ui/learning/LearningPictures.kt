package robotran.ui.learning

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.learning.Lessons
import robotran.learning.WorldGallery
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.uikit.*
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Settings
import kotlin.test.Test

/** Writes pictures of the learning pages to build/pictures for review. */
class LearningPictures {
    @Test
    fun `every page can be photographed, in every size and theme, in German and with large text`() {
        for (look in Look.entries) {
            drawWorlds(look.settings)
            drawLessons(look.settings)
            val workshop = runBlocking { openWorkshop() }
            workshop.handle(SettingsEvent.SettingsChanged(look.settings))
            photograph(workshop, look, "first-run") { handle(LearningEvent.PageRequested(LearningPage.FIRST_RUN)) }
            photograph(workshop, look, "worlds") { handle(LearningEvent.PageRequested(LearningPage.WORLDS)) }
            photograph(workshop, look, "help") { handle(LearningEvent.HelpRequested("repeat 4 times", 2)) }
            photograph(workshop, look, "words") { handle(LearningEvent.HelpRequested("side", 2)) }
            photograph(workshop, look, "tutorial") {
                handle(LearningEvent.PageClosed)
                handle(LearningEvent.TutorialStarted)
                handle(LearningEvent.StepChosen(2))
            }
            photograph(workshop, look, "fitting-hint") {
                handle(ProgramEvent.ProgramEdited(Lessons.all[2].solution.text.replace("left", "right")))
                handle(RunEvent.RunPressed)
                advance(12_000)
                handle(LearningEvent.TutorialFolded(false))
                handle(LearningEvent.HintRequested(true))
            }
            photograph(workshop, look, "hint") {
                handle(ProgramEvent.ProgramEdited(Lessons.all[2].solution.text))
                handle(RunEvent.RunPressed)
                advance(12_000)
                handle(LearningEvent.TutorialFolded(false))
            }
            photograph(workshop, look, "folded") { handle(LearningEvent.TutorialFolded(true)) }
            drawOwn(workshop, look.settings)
            photograph(workshop, look, "map") { handle(LearningEvent.PageRequested(LearningPage.MAP)) }
            photograph(workshop, look, "map-further") {
                handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == "line" }))
                handle(LearningEvent.PageRequested(LearningPage.MAP))
            }
            photograph(workshop, look, "teachers") { handle(LearningEvent.PageRequested(LearningPage.TEACHERS)) }
            workshop.close()
        }
    }

    /** The thumbnails load in the background; here they are needed at once, of any size. */
    private fun drawLessons(settings: Settings) = runBlocking {
        val colours = if (settings.theme == AppTheme.DARK) RobotranColours.DARK else RobotranColours.LIGHT
        for (lesson in Lessons.all) {
            LessonPictures.of(
                ShownLesson(lesson.on(BrickKind.default), own = null),
                SheetColours.of(colours),
                PictureBounds.of(280, 210, density = 1f),
            )
        }
    }

    private fun drawOwn(workshop: Workshop, settings: Settings) = runBlocking {
        val colours = if (settings.theme == AppTheme.DARK) RobotranColours.DARK else RobotranColours.LIGHT
        for ((name, own) in workshop.state.learning.drawings) {
            val lesson = checkNotNull(Lessons.named(name)).on(BrickKind.default)
            LessonPictures.of(
                ShownLesson(lesson, own),
                SheetColours.of(colours),
                PictureBounds.of(280, 210, density = 1f),
            )
        }
    }

    /** The thumbnails load in the background; here they are needed at once. */
    private fun drawWorlds(settings: Settings) = runBlocking {
        val colours = if (settings.theme == AppTheme.DARK) RobotranColours.DARK else RobotranColours.LIGHT
        for (world in WorldGallery.worlds) {
            WorldPictures.of(
                world,
                SheetColours.of(colours),
                PictureBounds.of(272, 170, density = 1f),
            )
        }
    }

    private fun photograph(workshop: Workshop, look: Look, name: String, prepare: Workshop.() -> Unit) {
        workshop.prepare()
        photograph(workshop, look.width, look.height).keepAs("learning/${look.name.lowercase()}-$name")
    }

    private enum class Look(val width: Int, val height: Int, val settings: Settings) {
        PHONE(411, 891, Settings(theme = AppTheme.LIGHT)),
        PHONE_DARK_LARGE(411, 891, Settings(theme = AppTheme.DARK, textScale = 2f)),
        TABLET(1280, 800, Settings(theme = AppTheme.LIGHT)),
        TABLET_GERMAN_DARK(1280, 800, Settings(theme = AppTheme.DARK, language = Language.GERMAN)),
        LAPTOP_LARGE(1440, 900, Settings(theme = AppTheme.LIGHT, textScale = 2f)),
    }
}
