package robotran.simulation.nxt

import kotlinx.coroutines.test.runTest
import robotran.brick.program.BrickProgram
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.exampleTexts
import robotran.simulation.grade.runForGoals
import robotran.simulation.nxtRuns
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.report
import robotran.simulation.runUnattended
import robotran.world.LightFacing
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.time.Duration.Companion.minutes

/**
 * Runs the examples and some Java programs on an NXT, and compares the reports with those in `resources/nxt-runs`. Their
 * trace hash covers every pose and call, so that all targets agree in each of them. `record-runs.sh` updates them.
 */
class NxtRecordedRunsTest {
    /** The report as it is, if it is not the one in the resources. */
    private suspend fun difference(
        name: String,
        world: World,
        program: BrickProgram,
        facing: LightFacing? = null,
    ): String? {
        val session =
            Session(
                world,
                listOf(RobotProgramSet(listOf(program), lightFacing = facing)),
                loadPhysicsEngine(),
                Language.ENGLISH,
            )
        // As the command line does, which records them: goals are evaluated once nothing moves any more.
        if (world.goals.isEmpty()) {
            session.runUnattended(60_000)
        } else {
            session.runForGoals(60_000, endsWhenDecided = false)
        }
        val report = session.report().toJson() + "\n"
        session.close()
        return "$name: $report".takeIf { nxtRuns["$name.report.json"] != report }
    }

    private fun World.with(robot: RobotDescription) = copy(robots = robots.map { it.copy(description = robot) })

    private fun world(name: String, realism: Double): World {
        val world = assertIs<WorldFileResult.Success>(
            readWorld(BuiltInWorlds.texts.getValue("$name.world.json"), Language.ENGLISH),
        ).world
        return world.with(ReadyRobots.NXT_PENBOT).copy(realism = realism)
    }

    @Test
    fun `examples in Robolang make their recorded runs`() = runTest(timeout = 10.minutes) {
        val differences = exampleTexts.mapNotNull { (file, text) ->
            val target = RobotTarget.Nxt(5.6, 11.4)
            // Not all examples are for an NXT.
            val ready =
                compileRobolang(
                    file,
                    text,
                    target,
                    messages = RobolangMessages.of(Language.ENGLISH),
                ) as? RobolangResult.Success
                    ?: return@mapNotNull null
            val facing = ready.program.lightSensorFacing?.let { LightFacing.valueOf(it.name) }
            difference(file.removeSuffix(".robo"), nxtPlain, ready.program, facing)
        }
        assertEquals("", differences.joinToString("\n"))
    }

    @Test
    fun `Java programs make their recorded runs`() = runTest(timeout = 10.minutes) {
        val worlds = mapOf(
            "PilotSquare" to nxtPlain,
            "FollowLine" to world("line-loop", 1.0),
            "Wanderer" to world("obstacle-course", 1.0),
            "Rotations" to nxtPlain.with(ReadyRobots.LINE_FOLLOWER).copy(realism = 1.0),
        )
        val differences = worlds.mapNotNull { (name, world) -> difference(name, world, nxj(name)) }
        assertEquals("", differences.joinToString("\n"))
    }
}
