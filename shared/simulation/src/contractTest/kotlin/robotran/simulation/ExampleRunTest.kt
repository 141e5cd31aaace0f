package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.LightFacing
import robotran.world.Penbot
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/**
 * Runs the examples like `robotran run` and compares the reports with those in `resources/runs`. Their trace hash
 * covers every tick's pose and every ROM call, so all targets make the same calls at the same times. Short ROM logs are
 * stored there too, to analyse a different hash. The tests of the command line and the web page use the same records;
 * `record-runs.sh` updates them.
 */
class ExampleRunTest {
    private suspend fun run(name: String): Session {
        val target = RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)
        val result =
            assertIs<RobolangResult.Success>(
                compileRobolang(
                    name,
                    exampleTexts.getValue(name),
                    target,
                    messages = RobolangMessages.of(Language.ENGLISH),
                ),
            )
        val facing = result.program.lightSensorFacing?.let { LightFacing.valueOf(it.name) }
        val load = RobotProgramSet(listOf(result.program), lightFacing = facing)
        return Session(BuiltInWorlds.plain, listOf(load), loadPhysicsEngine(), Language.ENGLISH).apply {
            runUnattended(60_000)
            close()
        }
    }

    @Test
    fun `every example makes its recorded run`() = runTest(timeout = 5.minutes) {
        assertTrue(exampleTexts.isNotEmpty())
        for (name in exampleTexts.keys) {
            val session = run(name)
            val record = name.removeSuffix(".robo")
            val callLog = session.callLog.entries.joinToString("") { it.text + "\n" }
            assertEquals(
                expectedRuns["$record.rom-log.txt"],
                callLog.takeIf {
                    it.length <= LONGEST_RECORDED_LOG
                },
                name,
            )
            assertEquals(expectedRuns["$record.report.json"], session.report().toJson() + "\n", name)
        }
    }

    @Test
    fun `every recorded run is that of an example`() {
        assertEquals(
            exampleTexts.keys.map { it.removeSuffix(".robo") }.toSet(),
            expectedRuns.keys.map { it.substringBefore('.') }.toSet(),
        )
    }

    @Test
    fun `the square is closed and twenty centimetres wide`() = runTest {
        val session = run("square.robo")
        val end = session.state.robot.pose
        val start = BuiltInWorlds.plain.start
        assertEquals(start.x, end.x, 0.5)
        assertEquals(start.y, end.y, 0.5)
        assertEquals(start.heading, end.heading, 2.0)
        assertEquals(80.0, session.state.ink.lengthCentimetres, 1.0)
        val corners = session.state.ink.strokes.flatMap { it.points }
        assertEquals(20.0, corners.maxOf { it.x } - corners.minOf { it.x }, 0.3)
        assertEquals(20.0, corners.maxOf { it.y } - corners.minOf { it.y }, 0.3)
    }

    private companion object {
        /** In characters, as in `record-runs.sh`. */
        const val LONGEST_RECORDED_LOG = 4000
    }
}
