package robotran.programs

import robotran.brick.program.BrickProgram
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.simulation.Session
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.runUnattended
import robotran.tinyvm.config.TinyVmSpeed
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.math.abs
import kotlin.math.hypot
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/**
 * A Robolang program and its translation leave the robot at the same place. The virtual machine runs at unlimited speed
 * here: a real brick starts its wheels about a millisecond apart.
 */
internal class TranslatedPoses {
    private val compiler =
        ProgramCompiler(testTarget, JavaSettings(speed = TinyVmSpeed.UNLIMITED), language = Language.ENGLISH)

    /** Drives the programs with [texts] by path. At least [min] of them end by themselves and can be compared. */
    suspend fun compare(texts: Map<String, String>, min: Int) {
        val physics = loadPhysicsEngine()
        val differences = mutableListOf<String>()
        var compared = 0
        for ((path, text) in texts) {
            val program = robolangOf(path, text) ?: continue
            val java = (compiler.translated(program) as? ProgramResult.Success)?.program ?: continue
            val interpreted = drive(program, physics)
            if (!interpreted.ended) continue
            compared++
            differenceOf(interpreted.pose, drive(java, physics).pose, MANY_TURNS[path] ?: MAX_CENTIMETRES)?.let {
                differences +=
                    "$path: $it"
            }
        }
        assertEquals("", differences.joinToString("\n"))
        assertTrue(compared >= min, "only $compared programs were compared")
    }

    private fun drive(program: BrickProgram, physics: PhysicsEngine): Drive {
        val session = Session(BuiltInWorlds.plain, listOf(program), physics, Language.ENGLISH)
        session.runUnattended(MILLISECONDS)
        session.close()
        return Drive(session.state.robot.pose, ended = session.state.brick.run is RunState.Ended)
    }

    private fun differenceOf(interpreted: Pose, translated: Pose, maxCentimetres: Double): String? {
        val distance = hypot(interpreted.x - translated.x, interpreted.y - translated.y)
        val turned = abs(interpreted.heading - translated.heading).let { minOf(it, FULL_TURN - it) }
        return if (distance <= maxCentimetres && turned <= MAX_DEGREES) null else "$interpreted, translated $translated"
    }

    private class Drive(val pose: Pose, val ended: Boolean)

    private companion object {
        /** Longer than any program that ends by itself. */
        const val MILLISECONDS = 300_000
        const val MAX_CENTIMETRES = 0.2
        const val MAX_DEGREES = 2.0

        /** Turns 138 times. The wheels' slip in each turn depends on the millisecond in which it begins. */
        val MANY_TURNS = mapOf("flower.robo" to 1.0)
        const val FULL_TURN = 360.0
    }
}
