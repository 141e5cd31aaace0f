package robotran.cli.brick

import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import robotran.tower.simulated.SimulatedRom
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals

class FirmwareCommandTest : TowerTest() {
    private val recorded = tree.resolve("shared/tower/src/commonTest/resources/streams/madeup.srec")
    private val file = folder.resolve("lejos.srec").also { it.writeText(recorded.readText()) }

    @Test
    fun `a firmware gets onto the brick`() {
        val rom = SimulatedRom()
        assertEquals(0, execute(rom, "firmware", "$file"), console.complaints.joinToString("\n"))
        assertEquals(250, rom.received.size)
        assertEquals("The brick has its firmware, 250 bytes. Now you can send programs.", console.said.single())
        assertContains(console.mentions.first(), "lejos.srec is none of the firmwares that Robotran knows")
    }

    @Test
    fun `a file that is no firmware is refused before the tower is looked for`() {
        val text = file.readText()
        file.writeText("<html></html>")
        assertEquals(2, execute(SimulatedRom(), "firmware", "$file"))
        file.writeText(text.replace("S113801051", "S113801052"))
        assertEquals(2, execute(SimulatedRom(), "firmware", "$file"))
        assertEquals(2, execute(SimulatedRom(), "firmware", "$folder/missing.srec", "--language", "es"))
        val (another, damaged, missing) = console.complaints
        assertContains(another, "lejos.srec is not a firmware")
        assertContains(damaged, "lejos.srec is damaged in line 3")
        assertContains(missing, "No existe el archivo")
        assertEquals(emptyList(), console.mentions)
    }

    @Test
    fun `status tells LEGO's firmware with its voltage`() {
        assertEquals(0, execute(SimulatedLegoFirmware(millivolts = 7960), "brick", "status"))
        val sentences =
            listOf("The brick has LEGO's firmware 3.32. The ROM is version 3.1.", "The batteries have 7.9 V.")
        assertEquals(sentences, console.said)
    }

    @Test
    fun `status tells how to know leJOS from no firmware`() {
        assertEquals(0, execute(SimulatedLejos(), "brick", "status", "--port", "COM7"))
        assertContains(console.said.single(), "If its display shows a voltage, it is leJOS.")
    }

    @Test
    fun `status of a brick that is off fails`() {
        assertEquals(4, execute(SimulatedLejos(), "brick", "status") { it.isOn = false })
        assertContains(console.complaints.single(), "The brick does not answer.")
    }
}
