package robotran.cli.translate

import org.apache.commons.compress.archivers.zip.ZipFile
import org.w3c.dom.Element
import robotran.cli.CommandTest
import java.io.File
import java.nio.file.Path
import java.time.LocalDateTime
import java.util.TimeZone
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.io.path.readBytes
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Tests the output of `robotran translate --kit`. */
class KitTest : CommandTest() {
    private fun kit(program: String = square, name: String = "kit.zip"): Path {
        val kit = folder.resolve(name)
        assertEquals(
            0,
            commandLine.execute(listOf("translate", program, "--kit", "$kit")),
            console.complaints.joinToString(),
        )
        return kit
    }

    @Test
    fun `a kit has all that a real brick takes`() {
        val files = texts(kit())
        val names = listOf("Square.java", "square.robo", "README.txt", "build.xml", "download.sh", "download.bat")
        assertEquals(names.map { "Square/$it" }, files.keys.toList())
        assertEquals(File(square).readText(), files["Square/square.robo"])
        assertContains(files.getValue("Square/Square.java"), "public class Square {")
    }

    @Test
    fun `only the script is executable`() {
        val modes = ZipFile.builder().setPath(kit()).get().use { zip ->
            zip.entries.asSequence().associate {
                it.name to
                    it.unixMode
            }
        }
        assertEquals(0b111_101_101, modes.getValue("Square/download.sh") and 0b111_111_111)
        assertTrue((modes - "Square/download.sh").values.all { it and 0b111_111_111 == 0b110_100_100 })
    }

    @Test
    fun `the script is a shell's, and the lines of the batch file end as on Windows`() {
        val files = texts(kit())
        val script = folder.resolve("download.sh").also { it.writeText(files.getValue("Square/download.sh")) }
        val shell = ProcessBuilder("sh", "-n", "$script").redirectErrorStream(true).start()
        assertEquals("", shell.inputStream.readBytes().decodeToString())
        assertEquals(0, shell.waitFor())
        assertFalse('\r' in files.getValue("Square/download.sh"))
        val lines = files.getValue("Square/download.bat").split("\n")
        assertEquals("", lines.last())
        assertTrue(lines.dropLast(1).all { it.endsWith("\r") })
    }

    @Test
    fun `script and batch file compile, link and download in this order`() {
        val files = texts(kit())
        for (name in listOf("Square/download.sh", "Square/download.bat")) {
            val tools = Regex("""^(?:call )?(lejos\w+) """, RegexOption.MULTILINE).findAll(files.getValue(name)).map {
                it.groupValues[1]
            }
            assertEquals(listOf("lejosc", "lejoslink", "lejosdl"), tools.toList(), name)
        }
    }

    @Test
    fun `the build file has a target for each step, one after the other`() {
        val project = DocumentBuilderFactory.newInstance().newDocumentBuilder()
            .parse(texts(kit()).getValue("Square/build.xml").byteInputStream()).documentElement
        val targets = project.getElementsByTagName("target").let { list ->
            (0 until list.length).map { list.item(it) as Element }
        }
        assertEquals("download", project.getAttribute("default"))
        assertEquals(
            listOf("compile" to "", "link" to "compile", "download" to "link"),
            targets.map { it.getAttribute("name") to it.getAttribute("depends") },
        )
        val tools = targets.map {
            it.getElementsByTagName("exec").item(0) as Element
        }.map { it.getAttribute("executable") }
        assertEquals(
            listOf("lejosc", "lejoslink", "lejosdl"),
            tools.map {
                it.substringAfterLast('/').substringBefore('$')
            },
        )
    }

    @Test
    fun `the page is one page and says how to calibrate`() {
        val page = texts(kit()).getValue("Square/README.txt")
        assertTrue(page.lines().size <= 60, "${page.lines().size} lines")
        assertTrue(page.lines().all { it.length <= 100 })
        for (words in listOf(
            "forward 100",
            "turn left 360",
            "MILLISECONDS_PER_CENTIMETRE",
            "MILLISECONDS_PER_DEGREE",
            "62.5f",
        )) {
            assertContains(page, words)
        }
        val java = texts(kit()).getValue("Square/Square.java")
        assertContains(java, "static final float MILLISECONDS_PER_CENTIMETRE")
        assertContains(java, "static final float MILLISECONDS_PER_DEGREE")
    }

    @Test
    fun `a kit is the same to the last byte whenever and wherever it is made`() {
        val first = kit(name = "first.zip").readBytes()
        val zone = TimeZone.getDefault()
        try {
            TimeZone.setDefault(TimeZone.getTimeZone("Pacific/Kiritimati"))
            assertContentEquals(first, kit(name = "second.zip").readBytes())
        } finally {
            TimeZone.setDefault(zone)
        }
        val times = ZipFile.builder().setPath(folder.resolve("first.zip")).get().use { zip ->
            zip.entries.asSequence().map { it.timeLocal }.toSet()
        }
        assertEquals(setOf(LocalDateTime.of(1980, 1, 1, 0, 0)), times)
    }

    @Test
    fun `an odd name of a file is plain in the kit`() {
        val program = folder.resolve("2 München!.robo").also { it.writeText("forward 10\n") }
        val files = texts(kit("$program"))
        assertContains(files.keys, "Program2Muenchen/Program2Muenchen.java")
        assertContains(files.keys, "Program2Muenchen/2 München!.robo")
        assertContains(files.getValue("Program2Muenchen/download.sh"), "Program2Muenchen.java")
    }

    @Test
    fun `a program in Java has the same kit, with all its sources`() {
        val main = javaProgram("Drive", "new Car().go();")
        val car = program("public class Car {\n    void go() {\n    }\n}\n", "Car.java")
        val kit = folder.resolve("java.zip")
        assertEquals(
            0,
            commandLine.execute(listOf("translate", car, main, "--kit", "$kit")),
            console.complaints.joinToString(),
        )
        val files = texts(kit)
        val names = listOf("Car.java", "Drive.java", "README.txt", "build.xml", "download.sh", "download.bat")
        assertEquals(names.map { "Drive/$it" }, files.keys.toList())
        assertEquals(File(main).readText(), files["Drive/Drive.java"])
        val steps =
            listOf("lejosc -encoding UTF-8 Car.java Drive.java", "lejoslink -o Drive.bin Drive", "lejosdl Drive.bin\n")
        assertContains(files.getValue("Drive/download.sh"), steps.joinToString("\n"))
        assertContains(files.getValue("Drive/download.bat"), "call lejoslink -o Drive.bin Drive || exit /b 1\r\n")
        val build = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(
            files.getValue("Drive/build.xml").byteInputStream(),
        )
        val elements = build.getElementsByTagName("arg").let { list ->
            (0 until list.length).map { list.item(it) as Element }
        }
        val arguments = elements.map { it.getAttribute("value") }
        assertEquals(listOf("", "Car.java", "Drive.java", "", "Drive", "Drive.bin"), arguments)
        assertContains(files.getValue("Drive/README.txt"), "Drive.java is where your Java program begins")
        assertTrue(files.getValue("Drive/README.txt").lines().all { it.length <= 100 })
    }

    @Test
    fun `a program in Java with a mistake has no kit`() {
        val kit = folder.resolve("java.zip")
        assertEquals(1, commandLine.execute(listOf("translate", javaProgram("Drive", "hop();"), "--kit", "$kit")))
        assertContains(console.complaints.single(), "Drive.java:5:")
        assertFalse(kit.toFile().exists())
        assertEquals(2, commandLine.execute(listOf("translate", "$folder/none.java", "--kit", "$kit")))
    }

    private fun texts(zip: Path): Map<String, String> = ZipFile.builder().setPath(zip).get().use { file ->
        file.entries.asSequence().associate { it.name to file.getInputStream(it).readBytes().decodeToString() }
    }
}
