package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.LightFacing
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import robotran.world.robot.RobotParameters
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotEquals
import kotlin.time.Duration.Companion.minutes

/** A robot that is built like the penbot runs as the penbot, bit for bit, wherever its description comes from. */
class PenbotAsDataTest {
    private val baseless = ReadyRobots.RCX_PENBOT.copy(title = "Mine", base = null)

    private fun World.driving(robot: RobotDescription) = copy(robots = robots.map { it.copy(description = robot) })

    private suspend fun hash(name: String, world: World): String {
        val parameters = RobotParameters.of(world.robots.first().description)
        val target = RobotTarget.Rcx(parameters.millisecondsPerCentimetre, parameters.millisecondsPerDegree)
        val ready =
            assertIs<RobolangResult.Success>(
                compileRobolang(
                    name,
                    exampleTexts.getValue(name),
                    target,
                    messages = RobolangMessages.of(Language.ENGLISH),
                ),
            )
        val facing = ready.program.lightSensorFacing?.let { LightFacing.valueOf(it.name) }
        val session =
            Session(
                world,
                listOf(RobotProgramSet(listOf(ready.program), lightFacing = facing)),
                loadPhysicsEngine(),
                Language.ENGLISH,
            )
        session.runUnattended(60_000)
        session.close()
        return session.traceHash
    }

    @Test
    fun `every recorded run is the same with a penbot of one's own`() = runTest(timeout = 5.minutes) {
        for (name in exampleTexts.keys) {
            val recorded = expectedRuns.getValue(name.removeSuffix(".robo") + ".report.json")
            assertEquals(recorded.substringAfter("\"traceHash\": \"").substringBefore('"'), hash(name, ownPenbot), name)
        }
    }

    @Test
    fun `so are runs with deviations in worlds with obstacles`() = runTest(timeout = 5.minutes) {
        for (name in listOf("maze", "obstacle-course", "line-loop", "sumo")) {
            val text = BuiltInWorlds.texts.getValue("$name.world.json")
            val world = assertIs<WorldFileResult.Success>(readWorld(text, Language.ENGLISH)).world.copy(realism = 1.0)
            for (program in listOf("wall-bouncer.robo", "line-follower.robo")) {
                val penbot = hash(program, world.driving(ReadyRobots.RCX_PENBOT))
                assertEquals(penbot, hash(program, world.driving(baseless)), "$program in $name")
            }
        }
    }

    @Test
    fun `another robot runs otherwise`() = runTest {
        val drive = baseless.drive.copy(wheelDiameter = 6.0)
        val other = BuiltInWorlds.plain.driving(baseless.copy(drive = drive))
        assertNotEquals(hash("square.robo", ownPenbot), hash("square.robo", other))
    }

    private val ownPenbot = BuiltInWorlds.plain.driving(baseless)
}
