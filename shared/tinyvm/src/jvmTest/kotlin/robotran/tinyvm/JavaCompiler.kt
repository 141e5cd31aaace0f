package robotran.tinyvm

import robotran.tinyvm.programs.libraryClassFiles
import java.io.ByteArrayOutputStream
import java.io.InputStream
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
import javax.tools.StandardLocation
import javax.tools.ToolProvider

/** The JDK's compiler in memory. It compiles to Java 8 class files against the brick's class library only. */
internal object JavaCompiler {
    private val compiler = checkNotNull(ToolProvider.getSystemJavaCompiler()) { "These tests need a JDK." }
    private val options = listOf("-source", "8", "-target", "8", "-g", "-proc:none", "-nowarn", "-Xlint:-options")

    /** The class files by internal name, and the compiler's errors. */
    class Compilation(val classes: Map<String, ByteArray>, val errors: List<String>)

    /** Returns the class files of a program by internal name. */
    fun compile(source: String): Map<String, ByteArray> {
        return compile(mapOf("Program" to source))
    }

    /** Returns the class files of a program with several [sources], by file name. */
    fun compile(sources: Map<String, String>): Map<String, ByteArray> {
        val compilation = tryToCompile(sources)
        if (compilation.errors.isNotEmpty()) throw AssertionError(compilation.errors.joinToString("\n"))
        return compilation.classes
    }

    /** Compiles [sources] by file name without `.java`. */
    fun tryToCompile(sources: Map<String, String>): Compilation {
        val problems = DiagnosticCollector<JavaFileObject>()
        val classes = compiler.getStandardFileManager(problems, Locale.ENGLISH, Charsets.UTF_8).use { files ->
            val memory = FilesInMemory(files)
            compiler.getTask(
                null,
                memory,
                problems,
                options,
                null,
                sources.map {
                    SourceInMemory(it.key, it.value)
                },
            ).call()
            memory.classes.entries.associate { it.key.replace('.', '/') to it.value.toByteArray() }
        }
        return Compilation(
            classes,
            problems.diagnostics.filter { it.kind == Diagnostic.Kind.ERROR }.map { it.toString() },
        )
    }
}

private class SourceInMemory(name: String, private val text: String) :
    SimpleJavaFileObject(URI("memory", null, "/$name.java", null), JavaFileObject.Kind.SOURCE) {
    override fun getCharContent(ignoreEncodingErrors: Boolean): CharSequence = text
}

/** The boxing classes that the compiler requires, though a brick has none. */
private val boxes: Map<String, ByteArray> = listOf("Boolean", "Byte", "Character", "Short", "Long", "Double", "Void")
    .associate { "java/lang/$it" to ClassAssembler("java/lang/$it", "java/lang/Object").assemble() }

/** A class of the library; [className] has dots. */
private class LibraryClass(val className: String, private val bytes: ByteArray) :
    SimpleJavaFileObject(URI("memory", null, "/$className.class", null), JavaFileObject.Kind.CLASS) {
    override fun openInputStream(): InputStream = bytes.inputStream()
}

/** Replaces the JDK's classes by the library. */
private class FilesInMemory(files: JavaFileManager) : ForwardingJavaFileManager<JavaFileManager>(files) {
    val classes = mutableMapOf<String, ByteArrayOutputStream>()

    override fun list(
        location: JavaFileManager.Location,
        packageName: String,
        kinds: Set<JavaFileObject.Kind>,
        recurse: Boolean,
    ): Iterable<JavaFileObject> {
        if (location != StandardLocation.PLATFORM_CLASS_PATH || JavaFileObject.Kind.CLASS !in kinds) return emptyList()
        return (boxes + libraryClassFiles).filterKeys { it.substringBeforeLast('/').replace('/', '.') == packageName }
            .map { (name, bytes) -> LibraryClass(name.replace('/', '.'), bytes) }
    }

    override fun inferBinaryName(location: JavaFileManager.Location, file: JavaFileObject): String =
        (file as? LibraryClass)?.className ?: super.inferBinaryName(location, file)

    override fun getJavaFileForOutput(
        location: JavaFileManager.Location,
        className: String,
        kind: JavaFileObject.Kind,
        sibling: FileObject?,
    ): JavaFileObject = object : SimpleJavaFileObject(URI.create("memory:///$className.class"), kind) {
        override fun openOutputStream(): OutputStream = ByteArrayOutputStream().also { classes[className] = it }
    }
}
