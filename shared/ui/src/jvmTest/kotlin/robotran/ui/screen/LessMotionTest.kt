package robotran.ui.screen

import kotlinx.coroutines.runBlocking
import robotran.ui.RobotranApp
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.Platform
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** What moves by itself, and that nothing does with less motion. */
class LessMotionTest {
    @Test
    fun `the robot of the welcome draws, or its drawing is finished`() =
        checkMotion { handle(LearningEvent.PageRequested(LearningPage.FIRST_RUN)) }

    @Test
    fun `Run has rings around it, or none`() = checkMotion { }

    @Test
    fun `a robot that has solved its task dances, or stands still`() = checkMotion { solve() }

    @Test
    fun `it does so in 3D, too`() = checkMotion {
        handle(SheetEvent.SpaceSwitched(true))
        solve()
    }

    @Test
    fun `what the system is told counts until the pupil chooses`() {
        val welcome: Workshop.() -> Unit = { handle(LearningEvent.PageRequested(LearningPage.FIRST_RUN)) }
        val described = MemoryPlatform(prefersLessMotion = true)
        assertFalse(moves(Settings(), welcome, described), "It moves although the system is told not to.")
        assertTrue(
            moves(Settings(lessMotion = false), welcome, described),
            "It does not move although the pupil wants it.",
        )
    }

    private fun Workshop.solve() {
        handle(LearningEvent.TutorialStarted)
        handle(ProgramEvent.ProgramEdited(checkNotNull(state.learning.tutorial).current.solution.text))
        handle(RunEvent.RunPressed)
        advance(30_000)
        // The clock goes on until the robot has rested for a while, also with less motion.
        advance(1_000)
    }

    private fun checkMotion(prepare: Workshop.() -> Unit) {
        assertTrue(moves(Settings(), prepare), "Nothing moves.")
        assertFalse(moves(Settings(lessMotion = true), prepare), "It moves with less motion.")
    }

    /** Whether one of a few pictures from the first second and a half differs from the others. */
    private fun moves(
        settings: Settings,
        prepare: Workshop.() -> Unit,
        platform: Platform = MemoryPlatform(),
    ): Boolean {
        val workshop = runBlocking { openWorkshop(platform = platform) }
        workshop.handle(SettingsEvent.SettingsChanged(settings))
        workshop.prepare()
        val pictures = onEventThread {
            val scene = sceneOf(WIDTH, HEIGHT) { RobotranApp(workshop, dark = false) }
            try {
                // What comes once, such as a measured text, has come.
                repeat(5) { scene.render(it * FRAME) }
                List(4) { number ->
                    val picture = scene.render((5 + number * 20) * FRAME)
                    checkNotNull(picture.peekPixels()).buffer.bytes.contentHashCode()
                }
            } finally {
                scene.close()
            }
        }
        workshop.close()
        return pictures.distinct().size > 1
    }

    private companion object {
        const val WIDTH = 900
        const val HEIGHT = 700
        const val FRAME = 16_666_667L
    }
}
