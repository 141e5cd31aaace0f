package robotran.runcontrol

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.MeasuringUnit
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.RobotProgramSet
import robotran.simulation.SessionInput
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.ReadyRobots
import robotran.world.Wall
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class ChartLaneTest {
    @Test
    fun anRcxHasALaneForEachSensorAndMotor() = assertEquals(
        listOf("SENSOR_1", "SENSOR_2", "SENSOR_3", "MOTOR_A", "MOTOR_B", "MOTOR_C"),
        ChartLane.of(BrickKind.RCX).map { it.name },
    )

    @Test
    fun anNxtHasAFourthSensorAndTheCountersOfItsMotors() {
        val lanes = ChartLane.of(BrickKind.NXT)
        assertEquals(ChartLane.SENSOR_4, lanes[3])
        assertEquals(listOf("DEGREES_A", "DEGREES_B", "DEGREES_C", "BATTERY"), lanes.drop(7).map { it.name })
        assertEquals(listOf(0, 1, 2), lanes.filter { it.isDegrees }.map { it.port })
        assertEquals(11, lanes.size)
        assertEquals(4, lanes.count { it.isSensor })
    }

    @Test
    fun `a robot whose ports take motors and sensors has lanes of what is on them`() = assertEquals(
        listOf(
            "SENSOR_4",
            "SENSOR_5",
            "MOTOR_A",
            "MOTOR_B",
            "MOTOR_C",
            "DEGREES_A",
            "DEGREES_B",
            "DEGREES_C",
            "BATTERY",
        ),
        ChartLane.of(ReadyRobots.SPIKE_PENBOT).map { it.name },
    )

    @Test
    fun `a brick has a lane for each of its ports`() = assertEquals(
        (1..6).map { "SENSOR_$it" } + ('A'..'F').map { "MOTOR_$it" } + ('A'..'F').map { "DEGREES_$it" } + "BATTERY",
        ChartLane.of(BrickKind.SPIKE_PRIME).map { it.name },
    )

    @Test
    fun theChartShowsNothingOfASonarThatIsOff() = runTest {
        val plain = BuiltInWorlds.plainFor(BrickKind.NXT)
        val pose = plain.robots.first().start
        val wall = Wall(Point(pose.x + 40, pose.y - 20), Point(pose.x + 40, pose.y + 20), thickness = 2.0)
        val world = plain.copy(
            walls = listOf(wall),
            robots = listOf(plain.robots.first().copy(start = pose.copy(heading = 0.0))),
        )
        val player = run("wait 0.2 seconds\nif distance < 100\n  beep\nend\nwait 0.5 seconds", world)
        assertTrue(player.state.brick.run is RunState.Ended)
        val line = player.chart(ChartLane.SENSOR_4)
        val values = (0..<line.size).map(line::range)
        assertTrue(values[50].let { it != null && it.last < 100 }, "${values[50]}")
        assertTrue(values.all { it == null || it.last < 255 }, "$values")
        assertEquals(null, values.last())
        assertEquals(null, values.first())
    }

    @Test
    fun theChartOfAnNxtHasTheUnitsOfItsSensorsWhateverTheProgramChose() = runTest {
        val world = BuiltInWorlds.plainFor(BrickKind.NXT).copy(realism = 1.0)
        val player = run("wait 0.2 seconds\nmotor A turn 180\nshow distance\nwait 0.2 seconds", world)
        val units = ChartLane.of(BrickKind.NXT).associateWith { player.chart(it).unit }
        assertEquals(MeasuringUnit.NONE, units[ChartLane.SENSOR_1])
        assertEquals(MeasuringUnit.PERCENT, units[ChartLane.SENSOR_3])
        assertEquals(MeasuringUnit.CENTIMETRES, units[ChartLane.SENSOR_4])
        assertEquals(MeasuringUnit.PERCENT, units[ChartLane.MOTOR_A])
        assertEquals(MeasuringUnit.DEGREES, units[ChartLane.DEGREES_A])
        assertEquals(MeasuringUnit.MILLIVOLTS, units[ChartLane.BATTERY])

        fun all(lane: ChartLane) = player.chart(lane).let { line ->
            val values = (0..<line.size).mapNotNull(line::range)
            values.minOf { it.first }..values.maxOf { it.last }
        }
        assertEquals(0..0, all(ChartLane.SENSOR_1))
        assertTrue(all(ChartLane.SENSOR_3).let { it.first >= 0 && it.last <= 100 }, "${all(ChartLane.SENSOR_3)}")
        assertTrue(all(ChartLane.SENSOR_4).last <= 255)
        assertTrue(all(ChartLane.DEGREES_A).last in 170..200, "${all(ChartLane.DEGREES_A)}")
        val battery = all(ChartLane.BATTERY)
        assertTrue(battery.first in 6_000..<battery.last && battery.last < 8_500, "$battery")
    }

    private suspend fun run(source: String, world: World): RunPlayer {
        val drive = ReadyRobots.NXT_PENBOT.drive
        val target = RobotTarget.Nxt(drive.wheelDiameter, drive.track)
        val program = assertIs<RobolangResult.Success>(
            compileRobolang("test", source, target, messages = RobolangMessages.of(Language.ENGLISH)),
        ).program
        val player =
            RunPlayer(RunSetup(world, listOf(RobotProgramSet(listOf(program))), loadPhysicsEngine(), Language.ENGLISH))
        player.apply(SessionInput.RunSnippet(program, 0))
        player.pass(2_000)
        return player
    }
}
