package robotran.tinyvm

import java.io.ByteArrayOutputStream
import java.io.File
import java.io.OutputStream
import java.net.URI
import java.nio.file.Files
import java.util.Locale
import javax.tools.Diagnostic
import javax.tools.DiagnosticCollector
import javax.tools.FileObject
import javax.tools.ForwardingJavaFileManager
import javax.tools.JavaFileManager
import javax.tools.JavaFileObject
import javax.tools.SimpleJavaFileObject
import javax.tools.ToolProvider

/** Compiles Java against a small class library in the test's resources, all in memory. */
internal object JavaCompiler {
    private val compiler = checkNotNull(ToolProvider.getSystemJavaCompiler()) { "These tests need a JDK." }
    private val librarySources: List<JavaFileObject> = readLibrary()

    /** The class files of the library by their names with slashes. */
    val library: Map<String, ByteArray> = compile(librarySources)

    /** The class files of a program by their names with slashes, the library's left out. */
    fun compile(source: String): Map<String, ByteArray> = compile(librarySources + SourceInMemory("Program.java", source)) - library.keys

    private fun compile(sources: List<JavaFileObject>): Map<String, ByteArray> {
        val problems = DiagnosticCollector<JavaFileObject>()
        val nothing = Files.createTempDirectory("nothing").toFile().apply { deleteOnExit() }
        val options =
            listOf("-source", "8", "-target", "8", "-bootclasspath", nothing.path, "-g", "-proc:none", "-nowarn", "-Xlint:-options")
        val classes = compiler.getStandardFileManager(problems, Locale.ENGLISH, Charsets.UTF_8).use { files ->
            val memory = ClassesInMemory(files)
            compiler.getTask(null, memory, problems, options, null, sources).call()
            memory.classes.entries.associate { it.key.replace('.', '/') to it.value.toByteArray() }
        }
        val errors = problems.diagnostics.filter { it.kind == Diagnostic.Kind.ERROR }
        if (errors.isNotEmpty()) throw AssertionError(errors.joinToString("\n"))
        return classes
    }

    private fun readLibrary(): List<JavaFileObject> {
        val folder = File(checkNotNull(javaClass.getResource("/library")) { "The class library is missing." }.toURI())
        return folder.walk().filter { it.extension == "java-stub" }.map { file ->
            SourceInMemory(file.relativeTo(folder).invariantSeparatorsPath.replace(".java-stub", ".java"), file.readText())
        }.toList()
    }
}

private class SourceInMemory(name: String, private val text: String) :
    SimpleJavaFileObject(URI("memory", null, "/$name", null), JavaFileObject.Kind.SOURCE) {
    override fun getCharContent(ignoreEncodingErrors: Boolean): CharSequence = text
}

private class ClassesInMemory(files: JavaFileManager) : ForwardingJavaFileManager<JavaFileManager>(files) {
    val classes = mutableMapOf<String, ByteArrayOutputStream>()

    override fun getJavaFileForOutput(
        location: JavaFileManager.Location,
        className: String,
        kind: JavaFileObject.Kind,
        sibling: FileObject?,
    ): JavaFileObject = object : SimpleJavaFileObject(URI.create("memory:///$className.class"), kind) {
        override fun openOutputStream(): OutputStream = ByteArrayOutputStream().also { classes[className] = it }
    }
}
