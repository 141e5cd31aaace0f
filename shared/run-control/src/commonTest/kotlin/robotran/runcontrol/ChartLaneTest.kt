package robotran.runcontrol

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.robot.RobotTarget
import robotran.simulation.RobotLoad
import robotran.simulation.SessionInput
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.ReadyRobots
import robotran.world.file.BuiltInWorlds
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
    fun theChartOfAnNxtHasTheUnitsOfItsSensorsWhateverTheProgramChose() = runTest {
        val drive = ReadyRobots.NXT_PENBOT.drive
        val target = RobotTarget.Nxt(drive.wheelDiameter, drive.track)
        val source = "wait 0.2 seconds\nmotor A turn 180\nshow distance\nwait 0.2 seconds"
        val program = assertIs<RobolangResult.Ready>(compileRobolang("test", source, target)).program
        val world = BuiltInWorlds.plainFor(BrickKind.NXT).copy(realism = 1.0)
        val setup = RunSetup(world, listOf(RobotLoad(listOf(program))), loadPhysicsEngine())
        val player = RunPlayer(setup)
        player.apply(SessionInput.RunNow(program, 0))
        player.pass(2_000)
        val units = ChartLane.of(BrickKind.NXT).associateWith { player.chart(it).unit }
        assertEquals(ChartUnit.NONE, units[ChartLane.SENSOR_1])
        assertEquals(ChartUnit.PERCENT, units[ChartLane.SENSOR_3])
        assertEquals(ChartUnit.CENTIMETRES, units[ChartLane.SENSOR_4])
        assertEquals(ChartUnit.PERCENT, units[ChartLane.MOTOR_A])
        assertEquals(ChartUnit.DEGREES, units[ChartLane.DEGREES_A])
        assertEquals(ChartUnit.MILLIVOLTS, units[ChartLane.BATTERY])

        fun all(lane: ChartLane) = player.chart(lane).let { line ->
            (0..<line.size).minOf { line.min(it) }..(0..<line.size).maxOf { line.greatest(it) }
        }
        assertEquals(0..0, all(ChartLane.SENSOR_1))
        assertTrue(all(ChartLane.SENSOR_3).let { it.first >= 0 && it.last <= 100 }, "${all(ChartLane.SENSOR_3)}")
        assertTrue(all(ChartLane.SENSOR_4).last <= 255)
        assertTrue(all(ChartLane.DEGREES_A).last in 170..200, "${all(ChartLane.DEGREES_A)}")
        val battery = all(ChartLane.BATTERY)
        assertTrue(battery.first in 6_000..<battery.last && battery.last < 8_500, "$battery")
    }
}
