package robotran.runcontrol

import robotran.brick.kind.BrickKind
import kotlin.test.Test
import kotlin.test.assertEquals

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
        assertEquals(listOf("DEGREES_A", "DEGREES_B", "DEGREES_C"), lanes.drop(7).map { it.name })
        assertEquals(listOf(0, 1, 2), lanes.filter { it.isDegrees }.map { it.port })
        assertEquals(10, lanes.size)
    }
}
