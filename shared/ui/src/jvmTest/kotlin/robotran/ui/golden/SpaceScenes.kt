package robotran.ui.golden

import kotlinx.coroutines.runBlocking
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.CameraKind
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import robotran.workshop.state.SpaceCamera
import kotlin.test.Test

/** Compares the 3D view of several worlds, on those screens and in those themes that [isCompared] says. */
abstract class SpaceScenes {
    /** @param number the scene's */
    internal abstract fun isCompared(number: Int, screen: SpaceScreen, theme: AppTheme): Boolean

    @Test
    fun `a robot that draws looks as it did`() = everywhere(0, "space-square") { runAWhile() }

    @Test
    fun `a maze looks as it did`() = everywhere(1, "space-maze") { handle(LearningEvent.WorldChosen("maze")) }

    @Test
    fun `a block and a yard look as they did`() = everywhere(2, "space-block-push") {
        handle(LearningEvent.WorldChosen("block-push"))
    }

    @Test
    fun `lamps in the dark look as they did`() = everywhere(3, "space-light-room") {
        handle(LearningEvent.WorldChosen("light-room"))
    }

    @Test
    fun `two robots in a ring look as they did`() = everywhere(4, "space-sumo") {
        handle(LearningEvent.WorldChosen("sumo"))
        handle(SheetEvent.SpaceCameraMoved(SpaceCamera(heading = 65.0, pitch = 34.0, zoom = 1.4)))
    }

    @Test
    fun `from behind the robot it looks as it did`() = everywhere(5, "space-follow") {
        runAWhile()
        handle(SheetEvent.CameraKindChosen(CameraKind.FOLLOW, 0))
    }

    @Test
    fun `with the robot's eye a slalom looks as it did`() = everywhere(6, "space-eye") {
        handle(LearningEvent.WorldChosen("slalom"))
        handle(SheetEvent.CameraKindChosen(CameraKind.ROBOT_EYE, 0))
    }

    private fun everywhere(number: Int, scene: String, prepare: Workshop.() -> Unit) {
        for (theme in THEMES) {
            for (screen in SpaceScreen.entries.filter { isCompared(number, it, theme) }) {
                val workshop = runBlocking { openWorkshop() }
                try {
                    workshop.handle(
                        SettingsEvent.SettingsChanged(Settings(theme = theme, lessMotion = true, isIn3D = true)),
                    )
                    workshop.prepare()
                    workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
                    workshop.handle(ScreenEvent.TaskShown(false))
                    workshop.handle(WorkshopEvent.NoticeDismissed)
                    val picture = photograph(workshop, screen.width, screen.height)
                    GoldenPicture.check("$scene-${screen.name.lowercase()}-${theme.name.lowercase()}", picture)
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

    private companion object {
        val THEMES = listOf(AppTheme.LIGHT, AppTheme.DARK)

        /** Milliseconds into the square program: somewhere on its third side. */
        const val HALF_DRAWN = 3900
    }
}

internal enum class SpaceScreen(val width: Int, val height: Int) {
    PHONE(411, 891),
    TABLET(1280, 800),
    LAPTOP(1440, 900),
}
