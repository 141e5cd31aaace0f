package robotran.robolang.translate

import java.io.File
import java.util.Locale
import javax.tools.Diagnostic
import javax.tools.DiagnosticCollector
import javax.tools.JavaFileObject
import javax.tools.ToolProvider

/** Reads translations for an NXT against the sources of the class library, which are among the test resources. */
internal object NxjCompiler {
    private val compiler = checkNotNull(ToolProvider.getSystemJavaCompiler()) { "These tests need a JDK." }
    private val library: List<JavaFileObject> by lazy {
        val place = checkNotNull(javaClass.getResource("/lejos/nxt/Motor.java")) { "The class library is missing." }
        val folder = File(place.toURI()).parentFile.parentFile
        folder.walk().filter { it.extension == "java" }.map { file ->
            SourceInMemory("lejos/" + file.relativeTo(folder).invariantSeparatorsPath, file.readText())
        }.toList()
    }

    /** What javac has against [translations]; empty if nothing. */
    fun problems(translations: Collection<Translation>): List<String> {
        val problems = DiagnosticCollector<JavaFileObject>()
        val sources = library + translations.map { SourceInMemory(it.fileName, it.java) }
        val names = translations.map { "/" + it.fileName }.toSet()
        compiler.getStandardFileManager(problems, Locale.ENGLISH, Charsets.UTF_8).use { files ->
            compiler.getTask(null, files, problems, OPTIONS, null, sources).call()
        }
        return problems.diagnostics.filter { it.kind == Diagnostic.Kind.ERROR && it.source?.name in names }
            .map { "$it" }
    }

    /** Nothing is written; without a source path, javac would look for more sources among the test resources. */
    private val OPTIONS = listOf("--release", "8", "-proc:none", "-nowarn", "-Xlint:-options", "-sourcepath", "") +
        listOf("-Xmaxerrs", "10000", "-XDshould-stop.ifError=FLOW", "-XDcompilePolicy=check")
}
