package robotran.cli.brick

import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests `robotran send` with programs for LEGO's firmware. */
class SendToSlotsTest : TowerTest() {
    private val lego = SimulatedLegoFirmware()
    private val drive =
        program(
            "task main()\n{\n  start horn;\n  Wait(100);\n}\n\ntask horn() { horn2(); }\n\nsub horn2()\n" +
                "{\n  PlaySound(1);\n}\n",
            "drive.nqc",
        )
    private val stop = program("\ttask 0\n\tstop\n\tendt\n", "stop.lasm")

    @Test
    fun `programs get into slots from the one that is named on`() {
        assertEquals(0, execute(lego, "send", drive, stop, "--slot", "2"), console.complaints.joinToString("\n"))
        assertEquals(setOf("2 task 0", "2 task 1", "2 sub 0", "3 task 0"), lego.parts.keys)
        assertEquals(listOf(0x50.toByte()), lego.parts.getValue("3 task 0").toList())
        assertTrue(console.said.first().startsWith("The brick has program 2, "), console.said.first())
        assertTrue(console.said.last().startsWith("The brick has program 3, 1 bytes."), console.said.last())
    }

    @Test
    fun `an image gets onto the brick as it is`() {
        val image = "$folder/stop.rcx"
        assertEquals(0, execute(lego, "build", stop, "-o", image))
        assertEquals(0, execute(lego, "send", image), console.complaints.joinToString("\n"))
        assertEquals(setOf("1 task 0"), lego.parts.keys)
    }

    @Test
    fun `more programs than slots are refused`() {
        assertEquals(2, execute(lego, "send", drive, stop, "--slot", "5"))
        assertContains(console.complaints.single(), "A brick has 5 slots")
        assertEquals(emptySet(), lego.parts.keys)
    }

    @Test
    fun `a program with mistakes is not sent`() {
        val wrong = program("task main()\n{\n  Wat(1);\n}\n", "wrong.nqc")
        assertEquals(1, execute(lego, "send", stop, wrong))
        assertTrue(console.complaints.single().startsWith("$wrong:3:3: "), console.complaints.single())
        assertEquals(emptySet(), lego.parts.keys)
    }

    @Test
    fun `a brick with leJOS is told as such`() {
        assertEquals(4, execute(SimulatedLejos(), "send", stop))
        assertContains(console.complaints.single(), "LEGO's firmware")
    }

    @Test
    fun `programs for both firmwares are not sent together`() {
        assertEquals(1, execute(SimulatedLejos(), "send", square, stop))
        assertContains(console.complaints.single(), "LEGO's own firmware")
    }
}
