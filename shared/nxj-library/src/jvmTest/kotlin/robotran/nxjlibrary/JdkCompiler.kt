package robotran.nxjlibrary

import java.io.File
import java.io.StringWriter
import javax.tools.StandardLocation
import javax.tools.ToolProvider
import kotlin.io.path.createTempDirectory

/** The JDK's own compiler with the library's `lejos`. It reads both once, however many programs it compiles. */
internal class JdkCompiler : AutoCloseable {
    /** The folder of the class files of `lejos`. */
    val library: File = createTempDirectory("library").toFile()

    private val compiler = ToolProvider.getSystemJavaCompiler()
    private val files = compiler.getStandardFileManager(null, null, null)

    init {
        for ((name, bytes) in robotran.nxjlibrary.library.classFiles.filterKeys { it.startsWith("lejos/") }) {
            library.resolve("$name.class").apply { parentFile.mkdirs() }.writeBytes(bytes)
        }
        files.setLocation(StandardLocation.CLASS_PATH, listOf(library))
    }

    /** Writes the class files of the program at [path], whose source is in [file], to [folder]. */
    fun compile(path: String, file: File, folder: File) {
        files.setLocation(StandardLocation.CLASS_OUTPUT, listOf(folder))
        val problems = StringWriter()
        val options = listOf("-nowarn", "-Xlint:none", "--release", "8")
        val task = compiler.getTask(problems, files, null, options, null, files.getJavaFileObjects(file))
        check(task.call()) { "$path: $problems" }
    }

    override fun close() {
        files.close()
        library.deleteRecursively()
    }
}
