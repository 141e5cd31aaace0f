package robotran.cli.run

import robotran.cli.CommandTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals

/** Tests what `robotran run` says of a program that expects other sensors than the penbot has. */
class MissingSensorRunTest : CommandTest() {
    private fun complaintsAbout(statements: String): List<String> {
        val file = javaProgram("Feel", "$statements\nThread.sleep(100);")
        assertEquals(0, commandLine.execute(listOf("run", file, "--for", "1")))
        return console.complaints.toList().also { console.complaints.clear() }
    }

    @Test
    fun `a touch sensor is missing on port 2 is missed`() {
        val described = complaintsAbout("Sensor.S1.setTypeAndMode(1, 0x20);\nSensor.S2.setTypeAndMode(1, 0x20);")
        assertContains(described.single(), "touch sensor is missing on port 2")
        assertContains(described.single(), "Line 6")
    }

    @Test
    fun `a light sensor is missing on port 1 is missed if the program sets or powers one there`() {
        assertContains(
            complaintsAbout("Sensor.S1.setTypeAndMode(3, 0x80);").single(),
            "light sensor is missing on port 1",
        )
        assertContains(complaintsAbout("Sensor.S3.activate();").single(), "light sensor is missing on port 3")
    }

    @Test
    fun `a program that only reads, or sets what is there, is told nothing`() {
        assertEquals(emptyList(), complaintsAbout("LCD.showNumber(Sensor.S1.readRawValue());"))
        assertEquals(emptyList(), complaintsAbout("Sensor.S2.setTypeAndMode(3, 0x80);\nSensor.S2.activate();"))
        assertEquals(emptyList(), complaintsAbout("Sensor.S3.setTypeAndMode(1, 0x20);\nSensor.S3.activate();"))
    }

    @Test
    fun `rotation sensors are missed by a navigator that needs them`() {
        val described = complaintsAbout("new josx.robotics.RotationNavigator(5.6f, 11.2f, 1f);")
        assertContains(described.single(), "Rotation sensors are missing on ports 1 and 3")
    }

    @Test
    fun `the report names them`() {
        val file = javaProgram("Feel", "Sensor.S2.setTypeAndMode(1, 0x20);")
        commandLine.execute(listOf("run", file, "--for", "1", "--report", "-"))
        assertContains(console.said.single(), "\"missingSensors\"")
    }
}
