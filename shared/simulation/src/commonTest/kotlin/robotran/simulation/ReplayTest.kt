package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.simulation.physics.loadPhysicsEngine
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals

/** Compares hashes with recorded ones on every target, to prove that a run is the same everywhere. */
class ReplayTest {
    @Test
    fun `a square is the same run on every target`() = runTest {
        val session = startRun(ScriptedProgram.square)
        session.advance(10_000)
        assertEquals("1988632ed3a1556e", session.traceHash)
    }

    /** Drives into walls at all angles for a minute, slides along them and spins in corners. */
    private val hardProgram = ScriptedProgram {
        penDown()
        for (round in 0 until 40) {
            motors(ScriptedProgram.FORWARD, round % 8)
            pause(900)
            motors(if (round % 3 == 0) ScriptedProgram.FLOAT else ScriptedProgram.BRAKE, 7)
            turnRight(37.0 + 11 * (round % 5))
            if (round % 4 == 3) backward(6.0)
        }
    }

    @Test
    fun `a minute among walls is the same run on every target`() = runTest {
        val session = startRun(hardProgram)
        session.advance(60_000)
        assertEquals(
            """
            {
                "status": "ended",
                "seconds": 60.101,
                "pose": {
                    "x": 15.108,
                    "y": 47.682,
                    "heading": 128.099
                },
                "inkCentimetres": 584.169,
                "bumps": 11,
                "lcd": "9.0 0",
                "romCalls": 382,
                "traceHash": "8ba95d0c2bd07b80",
                "error": null,
                "goals": []
            }
            """.trimIndent(),
            session.report().toJson(),
        )
    }

    @Test
    fun `the same inputs at the same times give the same run`() = runTest {
        val session = startRun(hardProgram)
        session.advance(7_777)
        session.apply(SessionInput.Stop)
        session.advance(1_000)
        session.apply(SessionInput.Press(BrickButton.RUN))
        session.advance(50)
        session.apply(SessionInput.Release(BrickButton.RUN))
        session.advance(4_321)

        val loads = listOf(RobotProgramSet(listOf(hardProgram)))
        val again = Session.replay(
            session.world,
            loads,
            loadPhysicsEngine(),
            session.inputs,
            session.state.milliseconds,
            language = Language.ENGLISH,
        )

        assertEquals(session.traceHash, again.traceHash)
        assertEquals(session.state.robot, again.state.robot)
        assertEquals(session.inputs, again.inputs)
    }

    @Test
    fun `how time is asked for makes no difference`() = runTest {
        val inOne = startRun(ScriptedProgram.square).apply { advance(3_000) }
        val inPieces = startRun(ScriptedProgram.square).apply { repeat(1_000) { advance(3) } }
        assertEquals(inOne.traceHash, inPieces.traceHash)
    }

    @Test
    fun `an input at another time makes another run`() = runTest {
        val session = startRun(ScriptedProgram.square).apply { advance(3_000) }
        val later = session.inputs.map {
            if (it.input is SessionInput.Release) {
                it.copy(milliseconds = it.milliseconds + 1)
            } else {
                it
            }
        }
        val loads = listOf(RobotProgramSet(listOf(ScriptedProgram.square)))
        val other = Session.replay(
            session.world,
            loads,
            loadPhysicsEngine(),
            later,
            session.state.milliseconds,
            Language.ENGLISH,
        )
        assertNotEquals(session.traceHash, other.traceHash)
    }
}
