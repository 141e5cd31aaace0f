package robotran.cli.translate

import org.apache.commons.compress.archivers.zip.ZipFile
import org.w3c.dom.Element
import robotran.cli.CommandTest
import java.io.File
import java.nio.file.Path
import java.time.LocalDateTime
import java.util.TimeZone
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.io.path.createDirectories
import kotlin.io.path.readBytes
import kotlin.io.path.readText
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
    fun `the script compiles with the tool that leJOS has, then links and sends`() {
        val kit = unpacked(texts(kit()))
        for (compiler in listOf("lejosc", "lejosjc")) {
            val tools = folder.resolve("lejos-with-$compiler").resolve("bin").createDirectories()
            val calls = folder.resolve("$compiler.log")
            for (tool in listOf(compiler, "lejos")) {
                tools.resolve(tool).writeText("#!/bin/sh\necho $tool \"$@\" >> '$calls'\n")
                tools.resolve(tool).toFile().setExecutable(true)
            }
            val shell = ProcessBuilder("sh", "${kit.resolve("download.sh")}").redirectErrorStream(true)
            shell.environment()["LEJOS_HOME"] = "${tools.parent}"
            val process = shell.start()
            assertEquals("", process.inputStream.readBytes().decodeToString())
            assertEquals(0, process.waitFor())
            assertEquals("$compiler -encoding UTF-8 Square.java\nlejos Square\n", calls.readText())
        }
    }

    @Test
    fun `without leJOS the script says what to set`() {
        val kit = unpacked(texts(kit()))
        val shell = ProcessBuilder("sh", "${kit.resolve("download.sh")}").redirectErrorStream(true)
        shell.environment().remove("LEJOS_HOME")
        val process = shell.start()
        assertContains(process.inputStream.readBytes().decodeToString(), "set LEJOS_HOME")
        assertEquals(1, process.waitFor())
    }

    @Test
    fun `the batch file looks for the same tools`() {
        val lines = texts(kit()).getValue("Square/download.bat").lines().map { it.trim() }
        val steps = listOf(
            "set COMPILER=lejosc",
            "where lejosc >nul 2>nul || set COMPILER=lejosjc",
            "call %COMPILER% -encoding UTF-8 Square.java || exit /b 1",
            "call lejos Square",
        )
        assertEquals(steps, lines.filter { it in steps })
    }

    @Test
    fun `the build file compiles before it sends, on Unix and on Windows`() {
        val project = DocumentBuilderFactory.newInstance().newDocumentBuilder()
            .parse(texts(kit()).getValue("Square/build.xml").byteInputStream()).documentElement
        val targets = elementsOf(project, "target")
        assertEquals("download", project.getAttribute("default"))
        assertEquals(
            listOf("compile" to "", "download" to "compile"),
            targets.map { it.getAttribute("name") to it.getAttribute("depends") },
        )
        val bin = "\${lejos.bin}"
        val commands = targets.flatMap { elementsOf(it, "exec") }.map { exec ->
            val arguments = elementsOf(exec, "arg").map { it.getAttribute("value") + it.getAttribute("line") }
            exec.getAttribute("osfamily") to (listOf(exec.getAttribute("executable")) + arguments).joinToString(" ")
        }
        assertEquals(
            listOf(
                "unix" to "$bin/\${compiler} -encoding UTF-8 Square.java",
                "windows" to "cmd /c $bin\\\${compiler} -encoding UTF-8 Square.java",
                "unix" to "$bin/lejos Square",
                "windows" to "cmd /c $bin\\lejos Square",
            ),
            commands,
        )
    }

    @Test
    fun `the page begins with Robotran's own way`() {
        val page = texts(kit()).getValue("Square/README.txt")
        assertTrue(page.indexOf("robotran send Square.java") in 0 until page.indexOf("LEJOS_HOME"), page)
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
        assertContains(
            files.getValue("Drive/download.sh"),
            "\n\$compiler -encoding UTF-8 Car.java Drive.java\nlejos Drive\n",
        )
        assertContains(files.getValue("Drive/download.bat"), "call lejos Drive\r\n")
        val build = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(
            files.getValue("Drive/build.xml").byteInputStream(),
        )
        val sources = elementsOf(build.documentElement, "arg").map { it.getAttribute("value") }.filter { ".java" in it }
        assertEquals(listOf("Car.java", "Drive.java", "Car.java", "Drive.java"), sources)
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

    private fun elementsOf(parent: Element, name: String): List<Element> =
        parent.getElementsByTagName(name).let { list -> (0 until list.length).map { list.item(it) as Element } }

    /** Writes the files of a kit into a folder of the test. Returns the kit's own folder. */
    private fun unpacked(files: Map<String, String>): Path {
        for ((name, text) in files) {
            folder.resolve(name).also { it.parent.createDirectories() }.writeText(text)
        }
        return folder.resolve(files.keys.first()).parent
    }

    private fun texts(zip: Path): Map<String, String> = ZipFile.builder().setPath(zip).get().use { file ->
        file.entries.asSequence().associate { it.name to file.getInputStream(it).readBytes().decodeToString() }
    }
}
