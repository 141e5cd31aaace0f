package robotran.cli.check

import robotran.cli.CommandTest
import java.util.zip.ZipFile
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class NxtCheckTest : CommandTest() {
    private fun check(vararg arguments: String) = commandLine.execute(listOf("check") + arguments)

    @Test
    fun `the imports of Java tell its brick`() {
        assertEquals(0, check(nxjProgram("Fine", "Motor.A.rotate(90);")), console.complaints.joinToString())
        val wrong = nxjProgram("Wrong", "Motor.A.rotat(90);")
        assertEquals(1, check(wrong))
        assertContains(console.complaints.single(), "$wrong:7:")
    }

    @Test
    fun `Java is checked for the brick that is named`() {
        val forNxt = nxjProgram("Fine", "Motor.A.rotate(90);")
        assertEquals(1, check("--brick", "rcx", forNxt))
        assertContains(console.complaints.single(), "$forNxt:1:8: This program is for an NXT")
        console.complaints.clear()
        val anywhere = program(
            "public class Say { public static void main(String[] a) { System.out.println(1L); } }",
            "Say.java",
        )
        assertEquals(0, check("--brick", "nxt", anywhere), console.complaints.joinToString())
    }

    @Test
    fun `Robolang is checked for the brick that is named or that its header names`() {
        val forNxt = program("robot\n  brick nxt\nend\nshow \"hello\"", "nxt.robo")
        assertEquals(0, check(forNxt), console.complaints.joinToString())
        assertEquals(0, check("--brick", "nxt", "--lejos", "3.0", forNxt), console.complaints.joinToString())
        assertEquals(1, check("--brick", "rcx", forNxt))
        console.complaints.clear()
        val text = program("show distance", "text.robo")
        assertEquals(0, check("--brick", "nxt", text), console.complaints.joinToString())
        assertEquals(1, check(text))
    }

    @Test
    fun `translate writes Java for the brick that is named or that the header names`() {
        val drive = program("forward 20 cm", "drive.robo")
        assertEquals(0, commandLine.execute(listOf("translate", "--brick", "nxt", drive)))
        assertContains(console.said.single(), "import lejos.nxt.")
        console.said.clear()
        val forNxt = program("robot\n  brick nxt\nend\nforward 20 cm", "nxt.robo")
        assertEquals(0, commandLine.execute(listOf("translate", forNxt)))
        assertContains(console.said.single(), "import lejos.nxt.")
        console.said.clear()
        assertEquals(0, commandLine.execute(listOf("translate", drive)))
        assertContains(console.said.single(), "import josx.")
    }

    @Test
    fun `a kit for an NXT has what its own tools need`() {
        val forNxt = program("robot\n  brick nxt\nend\nforward 20 cm", "nxt.robo")
        val turn = nxjProgram("Turn", "Motor.A.rotate(90);")
        for ((name, source) in listOf("Nxt" to forNxt, "Turn" to turn)) {
            val kit = folder.resolve("$name.zip")
            assertEquals(0, commandLine.execute(listOf("translate", source, "--kit", "$kit")))
            ZipFile(kit.toFile()).use { zip ->
                val script = zip.getInputStream(zip.getEntry("$name/upload.sh")).readBytes().decodeToString()
                assertContains(script, "nxjc -encoding UTF-8 -d . $name.java\nnxjlink -o $name.nxj $name\n")
                assertTrue(zip.getEntry("$name/$name.java") != null)
            }
        }
    }

    @Test
    fun `an image of a program for an NXT is refused in a sentence`() {
        val forNxt = nxjProgram("Fine", "Motor.A.rotate(90);")
        assertEquals(1, commandLine.execute(listOf("build", forNxt)))
        assertEquals(
            "$forNxt:1:8: This program is for an NXT. Only programs for an RCX become an image.",
            console.complaints.single(),
        )
    }
}
