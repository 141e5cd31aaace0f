package robotran.ui.learning

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.learning.Lessons
import robotran.learning.WorldGallery
import robotran.projects.ProgramView
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.uikit.*
import robotran.workshop.Workshop
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.editableParts
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.test.Test

/** Pictures for review of what a pupil sees most: the whole screen in a dozen scenes, at five sizes, in three looks. */
class ScenePictures {
    @Test
    fun `a pupil's scenes can be photographed at every size`() {
        for (look in Look.entries) {
            drawCards(look.settings)
            for (screen in Screen.entries) {
                for ((scene, prepare) in SCENES) {
                    val workshop = runBlocking { openWorkshop() }
                    workshop.handle(SettingsEvent.SettingsChanged(look.settings))
                    workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
                    workshop.prepare()
                    // Run does it on a phone, where a lesson would cover the world.
                    if (screen.isPhone && scene in AFTER_RUN) workshop.handle(LearningEvent.TutorialFolded(true))
                    photograph(workshop, screen.width, screen.height)
                        .keepAs("scenes/$scene-${screen.name.lowercase()}-${look.name.lowercase()}")
                    workshop.close()
                }
            }
        }
    }

    /** The cards' pictures load in the background; here they are needed at once. */
    private fun drawCards(settings: Settings) = runBlocking {
        val colours = SheetColours.of(
            if (settings.theme == AppTheme.DARK) RobotranColours.DARK else RobotranColours.LIGHT,
        )
        for (world in WorldGallery.worlds) WorldPictures.of(world, colours, PictureBounds.of(272, 170, density = 1f))
        for (lesson in Lessons.all) {
            val shown = ShownLesson(lesson.on(BrickKind.default), own = null)
            LessonPictures.of(shown, colours, PictureBounds.of(280, 210, density = 1f))
        }
    }

    private enum class Screen(val width: Int, val height: Int) {
        PHONE(411, 891),
        PHONE_ACROSS(891, 411),
        TABLET(1280, 800),
        TABLET_UPRIGHT(800, 1280),
        LAPTOP(1440, 900),
        ;

        val isPhone: Boolean get() = minOf(width, height) < 600
    }

    private enum class Look(val settings: Settings) {
        LIGHT(Settings(lessMotion = true, theme = AppTheme.LIGHT)),
        DARK(Settings(lessMotion = true, theme = AppTheme.DARK)),
        GERMAN_LARGE(
            Settings(lessMotion = true, theme = AppTheme.LIGHT, language = Language.GERMAN, textScale = 2f),
        ),
    }

    private companion object {
        val AFTER_RUN = setOf("failure", "success", "robots")
        val SCENES: Map<String, Workshop.() -> Unit> = mapOf(
            "welcome" to { handle(LearningEvent.PageRequested(LearningPage.FIRST_RUN)) },
            "first" to { handle(ScreenEvent.PaneChosen(Pane.PROGRAM)) },
            "lesson" to { open("repeat") },
            "failure" to {
                open("repeat")
                runLesson { it.replace("left", "right") }
            },
            "success" to {
                open("repeat")
                runLesson { it }
            },
            "lessons" to { handle(LearningEvent.PageRequested(LearningPage.MAP)) },
            "worlds" to { handle(LearningEvent.PageRequested(LearningPage.WORLDS)) },
            "editor" to {
                handle(LearningEvent.WorldChosen("maze"))
                handle(WorldEditEvent.EditorOpened)
            },
            "palette" to {
                handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                handle(BlockEvent.DialogShown(BlockDialog.Palette))
            },
            "number" to {
                handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                val program = checkNotNull(state.programs.blocks).program
                val line = program.outline.lines.first { "forward" in it.span.textIn(program.text) }
                handle(BlockEvent.DialogShown(BlockDialog.Part(line.editableParts.last().span)))
            },
            "robots" to {
                open("right-of-way")
                handle(RunEvent.RunPressed)
                advance(4_000)
            },
            "settings" to { handle(SettingsEvent.SettingsShown(true)) },
            "poster" to {
                handle(RunEvent.RunPressed)
                advance(8_000)
                handle(ExportEvent.Requested)
                handle(ExportEvent.PosterChosen)
                handle(ExportEvent.MakingRequested)
            },
        )

        fun Workshop.open(lesson: String) =
            handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == lesson }))

        fun Workshop.runLesson(change: (String) -> String) {
            handle(ProgramEvent.ProgramEdited(change(Lessons.all.first { it.name == "repeat" }.solution.text)))
            handle(RunEvent.RunPressed)
            advance(20_000)
        }
    }
}
