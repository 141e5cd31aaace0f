package robotran.programs

import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.simulation.Session
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.runUnattended
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.math.abs
import kotlin.math.hypot
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** On a robot with an NXT, too, a Robolang program and its translation leave the robot at the same place. */
internal class NxtTranslatedPoses {
    private val compiler = ProgramCompiler(nxtTestTarget, language = Language.ENGLISH)

    /** Drives the programs with [texts] by path. At least [min] of them end by themselves and can be compared. */
    suspend fun compare(texts: Map<String, String>, min: Int) {
        val physics = loadPhysicsEngine()
        val differences = mutableListOf<String>()
        var compared = 0
        for ((path, text) in texts) {
            val source = Program(path.substringAfterLast('/'), ProgramLanguage.ROBOLANG, text)
            val program = (compiler.compileOrThrow(source) as? ProgramResult.Success)?.program ?: continue
            val java = (compiler.compileTranslation(source) as? ProgramResult.Success)?.program
            if (java == null) {
                differences += "$path: its translation is refused"
                continue
            }
            val interpreted = drive(program, physics)
            if (!interpreted.ended) continue
            compared++
            differenceOf(interpreted, drive(java, physics))?.let { differences += "$path: $it" }
        }
        assertEquals("", differences.joinToString("\n"))
        assertTrue(compared >= min, "only $compared programs were compared")
    }

    private fun drive(program: BrickProgram, physics: PhysicsEngine): Drive {
        val session = Session(BuiltInWorlds.plainFor(BrickKind.NXT), listOf(program), physics, Language.ENGLISH)
        session.runUnattended(MILLISECONDS)
        session.close()
        return Drive(session.state.robot.pose, session.state.brick.run)
    }

    private fun differenceOf(interpreted: Drive, translated: Drive): String? {
        val one = interpreted.pose
        val other = translated.pose
        val distance = hypot(one.x - other.x, one.y - other.y)
        val turned = abs(one.heading - other.heading).let { minOf(it, FULL_TURN - it) }
        return when {
            !translated.ended -> "its translation is ${translated.run}"
            distance > MAX_CENTIMETRES || turned > MAX_DEGREES -> "$one, translated $other"
            else -> null
        }
    }

    private class Drive(val pose: Pose, val run: RunState) {
        val ended: Boolean get() = run is RunState.Ended
    }

    private companion object {
        const val MILLISECONDS = 60_000
        const val MAX_CENTIMETRES = 0.5
        const val MAX_DEGREES = 2.0
        const val FULL_TURN = 360.0
    }
}
