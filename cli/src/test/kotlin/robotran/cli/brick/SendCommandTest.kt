package robotran.cli.brick

import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import robotran.tower.simulated.SimulatedRom
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class SendCommandTest : TowerTest() {
    private val lejos = SimulatedLejos()

    @Test
    fun `a program in Robolang gets onto the brick`() {
        assertEquals(0, execute(lejos, "send", square), console.complaints.joinToString("\n"))
        val image = assertNotNull(lejos.program)
        assertContentEquals(byteArrayOf(0xCA.toByte(), 0xF6.toByte()), image.copyOf(2))
        assertEquals("The brick has the program, ${image.size} bytes. Press Run.", console.said.single())
        assertEquals("The tower is at COM7.\n", console.mentions.first())
        assertContains(console.mentions.last(), Regex("""(\d+) of \1 blocks, 0 s left"""))
    }

    @Test
    fun `several programs get onto the brick together`() {
        val java = javaProgram("Beep", "Sound.beep();")
        assertEquals(0, execute(lejos, "send", square, java), console.complaints.joinToString("\n"))
        val image = assertNotNull(lejos.program)
        assertEquals(2, image[14], "the number of programs in the image")
    }

    @Test
    fun `a program with mistakes is not sent`() {
        assertEquals(1, execute(lejos, "send", program("foward 20\n")))
        assertContains(console.complaints.single(), ":1:1: There is no command \"foward\".")
        assertNull(lejos.program)
        assertEquals(emptyList(), console.mentions)
    }

    @Test
    fun `leJOS has no other slot than the first`() {
        assertEquals(2, execute(lejos, "send", square, "--slot", "2"))
        assertContains(console.complaints.single(), "leJOS has no slots")
        assertEquals(2, execute(lejos, "send", square, "--slot", "6"))
        assertEquals(0, execute(lejos, "send", square, "--slot", "1"))
    }

    @Test
    fun `a brick that is off is told with what to do`() {
        assertEquals(4, execute(lejos, "send", square, "--language", "de") { it.isOn = false })
        val (fault, remains) = console.complaints
        assertTrue(fault.startsWith("Der Stein antwortet nicht. Schalte ihn ein"))
        assertEquals("Der Stein hat dasselbe wie vorher.", remains)
    }

    @Test
    fun `a brick without leJOS is told with what to do`() {
        assertEquals(4, execute(SimulatedRom(), "send", square))
        assertContains(console.complaints.first(), "The brick has no leJOS. Send leJOS's firmware first, with robotran")
        console.complaints.clear()
        assertEquals(4, execute(SimulatedLegoFirmware(), "send", square))
        val (lego, remains) = console.complaints
        assertContains(lego, "This brick has LEGO's own firmware 3.32, and the program needs leJOS.")
        assertEquals("The brick has the same as before.", remains)
    }

    @Test
    fun `a machine without tower is told as such`() {
        assertEquals(4, execute(TestPorts(emptyMap()), "send", square))
        assertContains(console.complaints.single(), "There is no tower. Plug it in")
    }

    @Test
    fun `a port that cannot be opened is told with the reason`() {
        val sentences =
            mapOf(
                OpenFailure.GONE to "There is no port COM3.",
                OpenFailure.BUSY to "Another program uses COM3.",
                OpenFailure.NOT_ALLOWED to "You may not use COM3.",
                OpenFailure.HELD_BY_DRIVER to "A driver of the system holds COM3",
            )
        for ((reason, sentence) in sentences) {
            console.complaints.clear()
            val ports = TestPorts(mapOf("COM3" to OpenedTower.Failure(reason)))
            assertEquals(4, execute(ports, "send", square, "--port", "COM3"))
            assertContains(console.complaints.single(), sentence)
        }
    }

    @Test
    fun `a file that is not there is refused before the tower is looked for`() {
        assertEquals(2, execute(lejos, "send", "$folder/missing.robo"))
        assertContains(console.complaints.single(), "missing.robo")
        assertEquals(emptyList(), console.mentions)
    }
}
