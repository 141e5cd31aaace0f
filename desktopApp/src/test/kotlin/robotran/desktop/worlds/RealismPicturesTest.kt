package robotran.desktop.worlds

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.runUnattended
import robotran.ui.pictures.pngOf
import robotran.ui.sheet.RobotTrack
import robotran.ui.sheet.renderRuns
import robotran.world.file.BuiltInWorlds
import java.io.File
import kotlin.math.hypot
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Draws the same square with twenty seeds, as pictures in `build/pictures`. */
class RealismPicturesTest {
    private val physics = runBlocking { loadPhysicsEngine() }
    private val world = BuiltInWorlds.plain
    private val square = File(System.getProperty("robotran.tree")).resolve("examples/square.robo")

    @Test
    fun `the more realism, the more the runs of a program differ`() {
        val spreads = listOf(0.0, 0.5, 1.0).map { realism ->
            val tracks = (1..20).map { track(realism, it) }
            File("build/pictures/realism-$realism.png").apply {
                parentFile.mkdirs()
            }.writeBytes(pngOf(renderRuns(world, tracks)))
            tracks.maxOf { hypot(it.end.x - tracks.first().end.x, it.end.y - tracks.first().end.y) }
        }
        assertEquals(0.0, spreads[0])
        assertTrue(spreads[1] > 1 && spreads[2] > spreads[1] * 1.3, spreads.toString())
    }

    private fun track(realism: Double, seed: Int): RobotTrack {
        val noisy = world.copy(realism = realism, seed = seed)
        val session = Session(noisy, ShippedWorlds.loads(noisy, square), physics, Language.ENGLISH)
        session.runUnattended(MILLISECONDS)
        val state = session.state
        session.close()
        return RobotTrack(state.ink.strokes.flatMap { it.points }, state.robot.pose)
    }

    private companion object {
        const val MILLISECONDS = 30_000
    }
}
