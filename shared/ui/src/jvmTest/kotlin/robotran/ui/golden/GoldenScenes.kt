package robotran.ui.golden

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
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

/** Compares every part of the app with the reference images, on those screens and in those looks that [isCompared] says. */
abstract class GoldenScenes {
    internal abstract fun isCompared(scene: Scene, screen: Screen, look: Look): Boolean

    @Test
    fun `the first screen looks as it did`() = everywhere(Scene.FIRST) { }

    @Test
    fun `the program looks as it did`() = everywhere(Scene.PROGRAM) { handle(ScreenEvent.PaneChosen(Pane.PROGRAM)) }

    @Test
    fun `the brick looks as it did`() = everywhere(Scene.BRICK) {
        runAWhile()
        handle(ScreenEvent.PaneChosen(Pane.BRICK))
    }

    @Test
    fun `a run looks as it did`() = everywhere(Scene.RUN) { runAWhile() }

    @Test
    fun `mistakes look as they did`() = everywhere(Scene.MISTAKES) {
        handle(ProgramEvent.ProgramEdited("pen down\nrepaet 4 times\n  forwrd 20\n  turn left\nend\nbeep beep\n"))
        handle(RunEvent.RunPressed)
    }

    @Test
    fun `the world editor looks as it did`() = everywhere(Scene.WORLD_EDITOR) {
        handle(LearningEvent.WorldChosen("maze"))
        handle(WorldEditEvent.EditorOpened)
    }

    @Test
    fun `a world with lamps and blocks looks as it did`() = everywhere(Scene.BLOCK_PUSH) {
        handle(LearningEvent.WorldChosen("block-push"))
        handle(ScreenEvent.PaneChosen(Pane.WORLD))
    }

    @Test
    fun `the tutorial looks as it did`() = everywhere(Scene.TUTORIAL) { handle(LearningEvent.TutorialStarted) }

    @Test
    fun `the first page looks as it did`() = everywhere(Scene.FIRST_PAGE) {
        handle(LearningEvent.PageRequested(LearningPage.FIRST_RUN))
    }

    @Test
    fun `the settings look as they did`() = everywhere(Scene.SETTINGS) { handle(SettingsEvent.SettingsShown(true)) }

    private fun everywhere(scene: Scene, prepare: Workshop.() -> Unit) {
        for (look in Look.entries) {
            for (screen in Screen.entries.filter { isCompared(scene, it, look) }) {
                val workshop = runBlocking { openWorkshop() }
                try {
                    val settings = Settings(
                        language = look.language,
                        theme = look.theme,
                        textScale = look.textScale,
                        lessMotion = true,
                    )
                    workshop.handle(SettingsEvent.SettingsChanged(settings))
                    workshop.prepare()
                    val picture = photograph(workshop, screen.width, screen.height)
                    GoldenPicture.check("${scene.picture}-${screen.name.lowercase()}-${look.name.lowercase()}", picture)
                } finally {
                    workshop.close()
                }
            }
        }
    }

    private fun Workshop.runAWhile() {
        handle(RunEvent.RunPressed)
        advance(HALF_DRAWN)
    }

    internal enum class Scene {
        FIRST,
        PROGRAM,
        BRICK,
        RUN,
        MISTAKES,
        WORLD_EDITOR,
        BLOCK_PUSH,
        TUTORIAL,
        FIRST_PAGE,
        SETTINGS,
        ;

        val picture = name.lowercase().replace('_', '-')
    }

    internal enum class Screen(val width: Int, val height: Int) {
        PHONE(411, 891),
        PHONE_ACROSS(891, 411),
        TABLET(1280, 800),
        TABLET_UPRIGHT(800, 1280),
        LAPTOP(1440, 900),
    }

    internal enum class Look(val theme: AppTheme, val language: Language, val textScale: Float = 1f) {
        LIGHT(AppTheme.LIGHT, Language.ENGLISH),
        DARK(AppTheme.DARK, Language.ENGLISH),
        HIGH_CONTRAST(AppTheme.HIGH_CONTRAST, Language.ENGLISH),
        GERMAN(AppTheme.LIGHT, Language.GERMAN),
        LARGE_TEXT(AppTheme.LIGHT, Language.ENGLISH, textScale = 2f),
    }

    private companion object {
        /** Milliseconds into the square program: somewhere on its third side. */
        const val HALF_DRAWN = 3900
    }
}
