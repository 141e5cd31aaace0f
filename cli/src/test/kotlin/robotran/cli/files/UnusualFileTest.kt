package robotran.cli.files

import robotran.cli.CommandTest
import robotran.projects.Project
import robotran.projects.writeProject
import robotran.world.file.BuiltInWorlds
import java.nio.charset.Charset
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Files as people have them: in old encodings, and with names that Windows and mail programs make. */
class UnusualFileTest : CommandTest() {
    private val windows: Charset = Charset.forName("windows-1252")

    private val programs = mapOf(
        ".robo" to "// f\u00FCr M\u00E4xchen\nbeep\n",
        ".java" to "public class Karl {\n    // gr\u00FC\u00DF dich\n    public static void main(String[] a) { }\n}\n",
        ".nqc" to "// f\u00E4hrt\ntask main() {\n  Wait(10);\n}\n",
        ".lasm" to "; f\u00E4hrt\n    task 0\n    wait 2, 10\n    endt\n",
    )

    private fun file(name: String, bytes: ByteArray): String =
        folder.resolve(name).apply { writeBytes(bytes) }.toString()

    private fun execute(vararg arguments: String): Int = commandLine.execute(arguments.toList())

    private fun assertRemark(note: String, vararg arguments: String) {
        console.complaints.clear()
        console.said.clear()
        assertEquals(0, execute(*arguments), "${arguments.toList()}: ${console.complaints}")
        assertContains((console.complaints + console.said).joinToString("\n"), note)
    }

    @Test
    fun `programs in every language and encoding are run, checked, built and linked with a remark`() {
        val encodings = listOf(windows to "Windows-1252", Charsets.UTF_16LE to "UTF-16", Charsets.UTF_16BE to "UTF-16")
        for ((extension, text) in programs) {
            for ((charset, name) in encodings) {
                val path = file("Karl$extension", text.toByteArray(charset))
                val note = "$path is in $name, not in UTF-8. It was read all the same."
                for (command in listOf("run", "check", "link", "build")) assertRemark(note, command, path)
            }
        }
    }

    @Test
    fun `the characters of an old encoding are those that were written`() {
        val path = file("Karl.robo", "// \u00FC\u20AC\nbeep\n".toByteArray(windows))
        assertEquals(0, execute("format", path))
        assertContains(folder.resolve("Karl.robo").readText(), "\u00FC\u20AC")
    }

    @Test
    fun `programs with the names that Windows and mail programs make are read`() {
        for ((extension, text) in programs) {
            for (name in listOf("Karl$extension.txt", "Karl${extension.uppercase()}", "Karl$extension.TXT")) {
                val path = file(name, text.encodeToByteArray())
                val note = "$path was read as ${folder.resolve("Karl$extension")}."
                for (command in listOf("run", "check", "link", "build")) assertRemark(note, command, path)
                assertTrue(folder.resolve(name).toFile().delete())
            }
        }
    }

    @Test
    fun `translations are made of such files, too`() {
        val robolang = file("Karl.ROBO.txt", programs.getValue(".robo").toByteArray(windows))
        assertRemark("is in Windows-1252", "translate", robolang)
        assertRemark("was read as", "translate", "--to", "nqc", robolang)
        val nqc = file("Karl.NQC", programs.getValue(".nqc").toByteArray(windows))
        assertRemark("is in Windows-1252", "translate", nqc)
        val java = file("Karl.java.txt", programs.getValue(".java").toByteArray(windows))
        assertRemark("is in Windows-1252", "translate", "--kit", "$folder/kit.zip", java)
    }

    @Test
    fun `format writes a program in UTF-8 and says so`() {
        for (extension in listOf(".robo", ".nqc")) {
            val path = file("Karl$extension", programs.getValue(extension).toByteArray(windows))
            console.complaints.clear()
            assertEquals(1, execute("format", "--check", path))
            assertEquals(listOf("$path is in Windows-1252, not in UTF-8."), console.complaints)
            assertEquals(0, execute("format", path))
            assertEquals("$path was in Windows-1252 and is in UTF-8 now.", console.complaints.last())
            assertContains(folder.resolve("Karl$extension").readText(), Regex("f\u00FCr|f\u00E4hrt"))
            assertEquals(0, execute("format", "--check", path))
        }
    }

    @Test
    fun `such files are graded alone, in a folder and in a class`() {
        val world = tree.resolve("worlds/plain.world.json").readText().replaceFirst("\"atLeast\": 40", "\"atMost\": 10")
            .let { program(it, "goal.world.json") }
        val karl = file("Karl.robo.txt", programs.getValue(".robo").toByteArray(windows))
        assertRemark("Karl.robo.txt is in Windows-1252", "grade", world, karl)
        assertRemark("was read as", "grade", world, file("Karl.ROBO", "beep\n".encodeToByteArray()))
        assertTrue(folder.resolve("class").toFile().mkdirs())
        file("class/Karl.robo.txt", programs.getValue(".robo").toByteArray(windows))
        file("class/Ida.NQC", programs.getValue(".nqc").toByteArray(Charsets.UTF_16LE))
        file("class/Leo.java.txt", programs.getValue(".java").replace("Karl", "Leo").toByteArray(windows))
        assertRemark("Karl.robo.txt was read as Karl.robo.", "grade", world, "$folder/class")
        for (pupil in listOf("Ida", "Karl", "Leo")) assertContains(console.said.joinToString("\n"), pupil)
    }

    @Test
    fun `a world and a project are read in old encodings and by names in capitals`() {
        val text = writeProject(Project(BuiltInWorlds.plain.copy(title = "Gr\u00FC\u00DFe")))
        assertRemark("is in Windows-1252", "link", file("Plain.ROBOTRAN", text.toByteArray(windows)))
        val world = tree.resolve("worlds/plain.world.json").readText()
        assertRemark("is in UTF-16", "link", file("Plain.World.JSON", world.toByteArray(Charsets.UTF_16LE)))
        assertRemark("is in UTF-16", "run", square, "--world", "$folder/Plain.World.JSON", "--for", "1")
    }
}
