package robotran.cli.brick

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.legofirmware.image.RcxImageResult
import robotran.legofirmware.image.readRcxImage
import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import robotran.tower.simulated.brickAfter
import robotran.tower.simulated.programIn
import java.io.File
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs

class SendToLegoTest : TowerTest() {
    private val lego = SimulatedLegoFirmware()
    private val nqc = program("task main() { OnFwd(OUT_A + OUT_C); Wait(100); Off(OUT_A + OUT_C); }\n", "drive.nqc")
    private val lasm = program("\ttask 0\n\tplays 1\n\tendt\n", "beep.lasm")

    @Test
    fun `a program in NQC gets into its slot and runs there`() {
        assertEquals(0, execute(lego, "send", nqc, "--slot", "2"), console.complaints.joinToString("\n"))
        assertEquals("The brick has the program in slot 2, 16 bytes. Press Run.", console.said.single())
        assertEquals(MotorMode.FORWARD, brickAfter(lego.programIn(slot = 2), 500).motor(MotorPort.C).mode)
        assertEquals(MotorMode.BRAKE, brickAfter(lego.programIn(slot = 2), 1_500).motor(MotorPort.C).mode)
        assertEquals(2, lego.slot)
    }

    @Test
    fun `programs of all three kinds get into slots one after the other, byte for byte`() {
        val image = "$folder/drive.rcx"
        assertEquals(0, execute(lego, "build", nqc, "-o", image))
        assertEquals(0, execute(lego, "send", nqc, lasm, image, "--slot", "3"), console.complaints.joinToString("\n"))
        val built = assertIs<RcxImageResult.Success>(readRcxImage(File(image).readBytes())).image
        val code = built.chunks.single().code.toByteArray()
        assertContentEquals(code, lego.parts["3 task 0"])
        assertContentEquals(byteArrayOf(0x51, 1), lego.parts["4 task 0"])
        assertContentEquals(code, lego.parts["5 task 0"])
        assertEquals(2, execute(lego, "send", nqc, lasm, "--slot", "5"))
        assertContains(console.complaints.single(), "There are no 2 slots from slot 5 on")
    }

    @Test
    fun `all tasks and subroutines of a program get into its slot`() {
        val parts = program(
            "task main() { start horn; Wait(100); }\ntask horn() { tone(); }\nsub tone() { PlaySound(1); }\n",
            "parts.nqc",
        )
        assertEquals(0, execute(lego, "send", parts), console.complaints.joinToString("\n"))
        assertEquals(setOf("1 task 0", "1 task 1", "1 sub 0"), lego.parts.keys)
    }

    @Test
    fun `a program with mistakes is not sent, nor are others that were named with it`() {
        val wrong = program("task main() { OnFwd(OUT_A) }\n", "wrong.nqc")
        assertEquals(1, execute(lego, "send", nqc, wrong))
        assertContains(console.complaints.first(), "wrong.nqc:1:")
        assertEquals(emptySet(), lego.parts.keys)
        assertEquals(emptyList(), console.mentions)
    }

    @Test
    fun `programs for both firmwares cannot be sent together`() {
        assertEquals(2, execute(lego, "send", nqc, square))
        assertContains(console.complaints.single(), "These programs need two firmwares")
    }

    @Test
    fun `a brick with leJOS is told as such and keeps what it has`() {
        assertEquals(4, execute(SimulatedLejos(), "send", nqc))
        val (fault, remains) = console.complaints
        assertContains(fault, "This brick has leJOS, or no firmware, and this needs LEGO's own firmware.")
        assertEquals("The brick has the same as before.", remains)
    }

    @Test
    fun `firmware 1_0 takes programs that are built for it`() {
        val old = SimulatedLegoFirmware(version = 9)
        assertEquals(4, execute(old, "send", nqc))
        assertContains(console.complaints.first(), "or build the program with --target rcx")
        assertEquals(0, execute(old, "send", nqc, "--target", "rcx"), console.complaints.joinToString("\n"))
        assertEquals(setOf("1 task 0"), old.parts.keys)
    }

    @Test
    fun `a full brick says how to make room`() {
        assertEquals(4, execute(SimulatedLegoFirmware(room = 10), "send", nqc))
        assertContains(console.complaints.first(), "robotran brick empty 2 3")
        assertContains(console.complaints.last(), "Slot 1 of the brick is empty now")
    }

    @Test
    fun `slots are emptied`() {
        for (slot in 1..3) lego.parts["$slot task 0"] = byteArrayOf(1)
        assertEquals(0, execute(lego, "brick", "empty", "1", "3"))
        assertEquals(setOf("2 task 0"), lego.parts.keys)
        assertEquals(listOf("Slot 1 of the brick is empty.", "Slot 3 of the brick is empty."), console.said)
        assertEquals(2, execute(lego, "brick", "empty", "6"))
    }

    @Test
    fun `the datalog is printed or written as CSV`() {
        lego.datalog = listOf(0x40 to 55, 0x20 to 7)
        assertEquals(0, execute(lego, "brick", "datalog"))
        val csv = "entry,source,number,value\n1,sensor,1,55\n2,timer,1,7"
        assertEquals(csv, console.said.single())
        val file = File("$folder/log.csv")
        assertEquals(0, execute(lego, "brick", "datalog", "-o", file.path))
        assertEquals("$csv\n", file.readText())
        assertEquals("Wrote ${file.path}: 2 entries of the datalog.", console.said.last())
        lego.datalog = null
        assertEquals(0, execute(lego, "brick", "datalog"))
        assertContains(console.mentions.last(), "The datalog has no entries.")
        assertEquals(4, execute(SimulatedLejos(), "brick", "datalog"))
    }

    @Test
    fun `the clock is set`() {
        assertEquals(0, execute(lego, "brick", "clock", "9:05", "--language", "es"))
        assertEquals(9 to 5, lego.clock)
        assertEquals("El reloj del ladrillo muestra las 09:05.", console.said.single())
        assertEquals(2, execute(lego, "brick", "clock", "25:00"))
        assertContains(console.complaints.single(), "25:00 is not a time.")
        assertEquals(9 to 5, lego.clock)
        assertEquals(0, execute(lego, "brick", "clock"))
    }
}
