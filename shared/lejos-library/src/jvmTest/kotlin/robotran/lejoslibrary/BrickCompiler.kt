package robotran.lejoslibrary

import org.eclipse.jdt.core.compiler.batch.BatchCompiler
import java.io.File
import java.io.PrintWriter
import java.io.StringWriter
import kotlin.io.path.createTempDirectory

/** Compiles programs as the product does: by ECJ, with nothing but the library on the class path. */
internal object BrickCompiler {
    /** The class files, by name, and the lines of all mistakes, by the program's path. */
    class Compilation(val classes: Map<String, ByteArray>, val diagnostics: Map<String, Set<Int>>)

    fun compile(programs: Map<String, String>): Compilation {
        val folder = createTempDirectory("brick").toFile()
        try {
            return compile(programs, folder)
        } finally {
            folder.deleteRecursively()
        }
    }

    private fun compile(programs: Map<String, String>, folder: File): Compilation {
        val library = folder.resolve("library")
        for (name in LejosLibrary.classNames) {
            library.resolve("$name.class").apply {
                parentFile.mkdirs()
            }.writeBytes(checkNotNull(LejosLibrary.classFile(name)))
        }
        val sources = programs.map { (path, text) ->
            folder.resolve("sources").resolve(path).apply { parentFile.mkdirs() }.also { it.writeText(text) }
        }
        val output = folder.resolve("output")
        val problems = StringWriter()
        val places = listOf("-bootclasspath", library.path, "-classpath", library.path, "-d", output.path)
        BatchCompiler.compile(
            (
                OPTIONS + places + sources.map { it.path }
            ).toTypedArray(),
            PrintWriter(problems),
            PrintWriter(problems),
            null,
        )
        return Compilation(classesIn(output), diagnostics(problems.toString(), folder.resolve("sources")))
    }

    private fun classesIn(output: File): Map<String, ByteArray> =
        output.walk().filter { it.extension == "class" }.associate { file ->
            file.relativeTo(output).invariantSeparatorsPath.removeSuffix(".class") to file.readBytes()
        }

    private fun diagnostics(problems: String, sources: File): Map<String, Set<Int>> = MISTAKE.findAll(problems).groupBy(
        { File(it.groupValues[1]).relativeTo(sources).invariantSeparatorsPath },
        { it.groupValues[2].toInt() },
    ).mapValues { it.value.toSet() }

    private val MISTAKE = Regex("""ERROR in (.+\.java) \(at line (\d+)\)""")
    private val DIALECT = listOf("-source", "1.3", "-target", "1.1", "-proc:none", "-encoding", "UTF-8")
    private val OPTIONS = DIALECT + listOf("-g", "-preserveAllLocals", "-nowarn", "-proceedOnError")
}
