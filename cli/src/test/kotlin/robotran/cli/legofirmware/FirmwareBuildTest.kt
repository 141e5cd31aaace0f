package robotran.cli.legofirmware

import robotran.cli.CommandTest
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Tests `build` and `translate` for LEGO's own firmware. */
class FirmwareBuildTest : CommandTest() {
    private val image = folder.resolve("out/drive.rcx")
    private val drive = program("task main()\n{\n  OnFwd(OUT_A);\n  Wait(100);\n  Off(OUT_A);\n}\n", "drive.nqc")

    private fun execute(vararg arguments: String): Int {
        console.said.clear()
        console.complaints.clear()
        return commandLine.execute(arguments.toList())
    }

    @Test
    fun `NQC becomes an image for the firmware that is asked for`() {
        assertEquals(0, execute("build", drive, "-o", "$image"))
        val bytes = image.readBytes()
        assertEquals("RCXI", bytes.take(4).map { it.toInt().toChar() }.joinToString(""))
        assertEquals(RCX2, bytes[TARGET].toInt())
        assertContains(console.said.single(), "$image is written. The program takes 16 of the 6144 bytes")
        assertEquals(0, execute("build", drive, "-o", "$image", "--target", "RCX"))
        assertEquals(0, image.readBytes()[TARGET].toInt())
    }

    @Test
    fun `without a file for it the image is only measured`() {
        assertEquals(0, execute("build", drive))
        assertTrue(console.said.single().startsWith("The program takes 16 "), console.said.single())
        assertFalse(image.exists())
    }

    @Test
    fun `the listing tells the commands of the image`() {
        assertEquals(0, execute("build", drive, "--listing"))
        val lines = console.said.first().lines()
        assertContains(lines.first { it.startsWith("***") }, "*** Task 0 = main, size: 16 bytes")
        assertTrue(lines.any { it.startsWith("010 wait     100 ") }, console.said.first())
    }

    @Test
    fun `an image becomes assembly text, and that the same image again`() {
        assertEquals(0, execute("build", drive, "-o", "$image"))
        val lasm = folder.resolve("drive.lasm")
        assertEquals(0, execute("translate", "$image", "-o", "$lasm"))
        assertContains(lasm.readText(), "\twait\t2, 100")
        val again = folder.resolve("again.rcx")
        assertEquals(0, execute("build", "$lasm", "-o", "$again"))
        assertContentEquals(image.readBytes(), again.readBytes())
        assertEquals(0, execute("translate", drive))
        assertEquals(lasm.readText().trimEnd(), console.said.single())
    }

    @Test
    fun `Robolang becomes NQC`() {
        assertEquals(0, execute("translate", square, "--to", "nqc"))
        assertContains(console.said.single(), "task main()")
        val nqc = program(console.said.single(), "square.nqc")
        assertEquals(0, execute("check", nqc), console.complaints.joinToString())
    }

    @Test
    fun `what NQC cannot do is told with its place`() {
        val half = program("beep\nshow \"half\"\n")
        assertEquals(1, execute("translate", half, "--to", "nqc"))
        assertTrue(console.complaints.first().startsWith("$half:2:"), console.complaints.joinToString())
        assertContains(console.said.single(), "task main()")
        assertEquals(1, execute("build", half, "-o", "$image"))
        assertTrue(console.complaints.first().startsWith("$half:2:"), console.complaints.joinToString())
        assertFalse(image.exists())
    }

    @Test
    fun `Robolang becomes an image of LEGO's firmware if its name asks for that`() {
        assertEquals(0, execute("build", square, "-o", "$image"), console.complaints.joinToString())
        assertEquals(RCX2, image.readBytes()[TARGET].toInt())
        assertEquals(0, execute("translate", square, "--to", "lasm"))
        assertContains(console.said.single(), "\ttask\t0")
    }

    @Test
    fun `a mistake has file, line and column`() {
        val wrong = program("task main()\n{\n  Wat(1);\n}\n", "wrong.nqc")
        for (command in listOf("build", "translate", "check")) {
            assertEquals(1, execute(command, wrong), command)
            assertTrue(console.complaints.single().startsWith("$wrong:3:3: "), console.complaints.single())
        }
        val lasm = program("\ttask 0\n\tgone\n\tendt\n", "wrong.lasm")
        assertEquals(1, execute("build", lasm))
        assertTrue(console.complaints.single().startsWith("$lasm:2:2: "), console.complaints.single())
    }

    @Test
    fun `programs for both firmwares share no image`() {
        assertEquals(1, execute("build", square, drive, "-o", "$image"))
        assertContains(console.complaints.single(), "LEGO's own firmware")
    }

    @Test
    fun `other languages cannot become NQC`() {
        assertEquals(2, execute("translate", drive, "--to", "nqc"))
        assertEquals(2, execute("translate", drive, "--to", "java"))
        assertEquals(2, execute("translate", drive, "--to", "pascal"))
        assertEquals(2, execute("translate", square, "--to", "nqc", "--kit", "$folder/kit.zip"))
    }

    private companion object {
        /** Where an image says what it is for. */
        const val TARGET = 10
        const val RCX2 = 3
    }
}
