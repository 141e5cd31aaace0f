package robotran.cli

import robotran.console.RecordingConsole
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createParentDirectories
import kotlin.io.path.writeText
import kotlin.test.AfterTest

/** The base class of command tests: a recording console, a temporary folder, and the project's examples. */
abstract class CommandTest {
    internal val console = RecordingConsole()
    internal val commandLine = CommandLine(console, TestDesktop())
    protected val folder: Path = Files.createTempDirectory("robotran")
    protected val tree = File(System.getProperty("robotran.tree"))
    protected val square: String = tree.resolve("examples/square.robo").path

    @AfterTest
    fun tidyUp() {
        folder.toFile().deleteRecursively()
    }

    /** Writes [text] to a file in the folder and returns its path. */
    protected fun program(text: String, name: String = "mine.robo"): String =
        folder.resolve(name).also { it.createParentDirectories().writeText(text) }.toString()

    /** A Java program [name] with [statements] in its main method, starting on line 5. */
    protected fun javaProgram(name: String, statements: String): String {
        val body = statements.trimIndent().prependIndent("        ")
        val head =
            "import josx.platform.rcx.*;\n\npublic class $name {\n    public static void main(String[] args) throws " +
                "Exception {\n"
        return program("$head$body\n    }\n}\n", "$name.java")
    }

    /** A program [name] for an NXT with [statements] in its main method, starting on line 7. */
    protected fun nxjProgram(name: String, statements: String): String {
        val body = statements.trimIndent().prependIndent("        ")
        val head = "import lejos.nxt.*;\nimport lejos.util.*;\nimport lejos.robotics.navigation.*;\n\n" +
            "public class $name {\n    public static void main(String[] args) throws Exception {\n"
        return program("$head$body\n    }\n}\n", "$name.java")
    }
}
