package robotran.robolang.translate

import java.io.ByteArrayOutputStream
import java.io.File
import java.io.OutputStream
import java.net.URI
import java.util.Locale
import javax.tools.Diagnostic
import javax.tools.DiagnosticCollector
import javax.tools.FileObject
import javax.tools.ForwardingJavaFileManager
import javax.tools.JavaFileManager
import javax.tools.JavaFileObject
import javax.tools.SimpleJavaFileObject
import javax.tools.ToolProvider

/** Compiles Java in memory against the leJOS stubs in the test resources. */
internal object LejosCompiler {
    private val standIns: List<JavaFileObject> by lazy { readStandIns("/lejos") }
    private val nxtStandIns: List<JavaFileObject> by lazy { readStandIns("/nxj") }
    private val compiler = checkNotNull(ToolProvider.getSystemJavaCompiler()) { "These tests need a JDK." }

    /**
     * Returns the class files of [translations] and the stubs, by name. Throws with javac's message if one does not
     * compile.
     */
    fun compile(translations: Collection<Translation>): Map<String, ByteArray> = compile(translations, standIns)

    /** The same for translations for an NXT, with the stubs of leJOS NXJ. */
    fun compileForNxt(translations: Collection<Translation>): Map<String, ByteArray> =
        compile(translations, nxtStandIns)

    private fun compile(
        translations: Collection<Translation>,
        standIns: List<JavaFileObject>,
    ): Map<String, ByteArray> {
        val problems = DiagnosticCollector<JavaFileObject>()
        val sources = standIns + translations.map { SourceInMemory(it.fileName, it.java) }
        val classes = compiler.getStandardFileManager(problems, Locale.ENGLISH, Charsets.UTF_8).use { files ->
            val memory = ClassesInMemory(files)
            compiler.getTask(null, memory, problems, OPTIONS, null, sources).call()
            memory.classes.mapValues { it.value.toByteArray() }
        }
        val errors = problems.diagnostics.filter { it.kind == Diagnostic.Kind.ERROR }
        if (errors.isNotEmpty()) {
            throw AssertionError(
                errors.take(MAX_ERRORS).joinToString("\n") {
                    described(it, translations)
                },
            )
        }
        return classes
    }

    private fun described(problem: Diagnostic<out JavaFileObject>, translations: Collection<Translation>): String {
        val java = translations.firstOrNull { problem.source?.name?.endsWith(it.fileName) == true }?.java.orEmpty()
        return "$problem\n${java.lines().getOrNull(problem.lineNumber.toInt() - 1)}\n$java"
    }

    private fun readStandIns(place: String): List<JavaFileObject> {
        val folder = File(checkNotNull(javaClass.getResource(place)) { "The stand-ins are missing." }.toURI())
        return folder.walk().filter { it.extension == "java-stub" }.map { file ->
            SourceInMemory(
                file.relativeTo(folder).invariantSeparatorsPath.replace(".java-stub", ".java"),
                file.readText(),
            )
        }.toList()
    }

    private const val MAX_ERRORS = 3

    /** Without a source path, javac would look for sources among the test resources. */
    private val OPTIONS = listOf("--release", "8", "-proc:none", "-nowarn", "-Xlint:-options", "-sourcepath", "")
}

internal class SourceInMemory(name: String, private val text: String) :
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
