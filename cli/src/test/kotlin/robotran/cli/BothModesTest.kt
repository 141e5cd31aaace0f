package robotran.cli

import robotran.console.RecordingConsole
import java.io.File
import kotlin.io.path.createTempDirectory
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Examples, programs of lessons and worlds, and those in documents have no mistakes, true to the brick and forgiving. */
class BothModesTest {
    private val tree = File(System.getProperty("robotran.tree"))
    private val extracted = createTempDirectory("robotran-documents").toFile()

    @AfterTest
    fun delete() {
        extracted.deleteRecursively()
    }

    private fun programsIn(folder: String): List<File> = tree.resolve(folder).walk()
        .onEnter { it.name != "wrong" }
        .filter { it.extension in setOf("java", "robo", "nqc") }
        .sortedBy { it.path }
        .toList()

    /** The Java programs in documents, each as a file of its class. */
    private fun programsOfDocuments(): List<File> = listOf("docs", "learning/words")
        .flatMap { folder -> tree.resolve(folder).listFiles { file -> file.extension == "md" }.orEmpty().sorted() }
        .flatMap { document -> BLOCK.findAll(document.readText()).map { it.groupValues[1] } }
        .filter { "public class " in it }
        .mapIndexed { index, text -> fileOf("document-$index", text) }

    /** A Java program in a file that is called like its first class. */
    private fun fileOf(folder: String, text: String): File {
        val name = checkNotNull(MAIN_CLASS.find(text)).groupValues[1]
        return extracted.resolve("$folder/$name.java").apply {
            parentFile.mkdirs()
            writeText(text)
        }
    }

    /** Programs in Java, which are called after what they are for, under the name of their class. */
    private fun renamed(index: Int, file: File): File =
        if (file.extension == "java") fileOf("${file.nameWithoutExtension}-$index", file.readText()) else file

    private fun assertPass(programs: List<File>, vararg options: String) {
        val (java, others) = programs.partition { it.extension == "java" }
        for (mode in listOf(emptyList(), listOf("--forgiving"))) {
            // Java files of one call are one program. Other languages have no modes.
            val inOtherLanguages = listOf(others).filter { it.isNotEmpty() && mode.isEmpty() }
            for (files in java.map(::listOf) + inOtherLanguages) {
                val console = RecordingConsole()
                val arguments = listOf("check") + mode + options + files.map { it.path }
                val status = CommandLine(console, desktop = null).execute(arguments)
                val errors = console.complaints.filterNot { it.endsWith("(a warning)") }
                assertEquals(emptyList(), errors, "$mode")
                assertEquals(0, status, "$mode")
            }
        }
    }

    @Test
    fun `examples pass in both modes`() {
        val examples = programsIn("examples")
        assertTrue(examples.size >= 70, "${examples.size} examples")
        assertPass(examples)
    }

    @Test
    fun `programs of lessons and worlds pass in both modes`() {
        val byBrick = (programsIn("learning/lessons") + programsIn("learning/worlds"))
            .groupBy { file -> BRICKS.keys.find { start -> namesOf(file).any { it.startsWith(start) } } }
            .mapValues { (_, files) -> files.mapIndexed { index, file -> renamed(index, file) } }
        for ((brick, least) in mapOf("nxt-" to 20, "spike-" to 10, "buggy-" to 12, "board" to 6, null to 150)) {
            val files = byBrick.getValue(brick)
            assertTrue(files.size >= least, "${files.size} programs of $brick")
            assertPass(files, *brick?.let { arrayOf("--brick", BRICKS.getValue(it)) }.orEmpty())
        }
    }

    @Test
    fun `Java programs of documents pass in both modes`() {
        val programs = programsOfDocuments()
        assertTrue(programs.size >= 20, "${programs.size} programs")
        assertPass(programs)
    }

    /** The names of a program's file, its lesson or world, and its strand. */
    private fun namesOf(file: File): List<String> =
        listOf(file, file.parentFile, file.parentFile.parentFile).map { it.name }

    private companion object {
        /** The bricks of programs, worlds and strands whose names begin so; those of others are for an RCX. */
        val BRICKS = mapOf("nxt-" to "nxt", "spike-" to "spike-prime", "buggy-" to "microbit", "board" to "microbit")
        val BLOCK = Regex("```java\n(.*?)```", RegexOption.DOT_MATCHES_ALL)
        val MAIN_CLASS = Regex("""^(?:public )?class (\w+)""", RegexOption.MULTILINE)
    }
}
