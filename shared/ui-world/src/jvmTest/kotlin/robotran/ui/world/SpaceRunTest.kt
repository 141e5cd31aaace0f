package robotran.ui.world

import kotlinx.coroutines.runBlocking
import robotran.projects.Project
import robotran.simulation.RunReport
import robotran.simulation.physics.loadPhysicsEngine
import robotran.ui.RobotranApp
import robotran.ui.screen.onEventThread
import robotran.ui.screen.sceneOf
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.state.CameraKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class SpaceRunTest {
    @Test
    fun `a run is the same to the last bit, whether it is seen on the sheet or in 3D`() {
        val onSheet = run { }
        assertTrue(onSheet.inkCentimetres.toString() != "0", "nothing was drawn")
        for (kind in CameraKind.entries) {
            val inSpace = run {
                handle(SheetEvent.SpaceSwitched(true))
                handle(SheetEvent.CameraKindChosen(kind, 0))
            }
            assertEquals(onSheet, inSpace, "with the camera $kind")
        }
    }

    /** The report of some seconds of the square program, of which each frame is drawn. */
    private fun run(prepare: Workshop.() -> Unit): RunReport {
        val workshop = Workshop(Project(handyWorld), runBlocking { loadPhysicsEngine() })
        workshop.prepare()
        workshop.handle(RunEvent.RunPressed)
        onEventThread {
            val scene = sceneOf(WIDTH, HEIGHT) { RobotranApp(workshop, dark = false) }
            try {
                for (frame in 0 until FRAMES) scene.render(frame * FRAME_NANOSECONDS).close()
            } finally {
                scene.close()
            }
        }
        return workshop.report().also { workshop.close() }
    }

    private companion object {
        const val WIDTH = 640
        const val HEIGHT = 480
        const val FRAMES = 30
        const val FRAME_NANOSECONDS = 50_000_000L
    }
}
