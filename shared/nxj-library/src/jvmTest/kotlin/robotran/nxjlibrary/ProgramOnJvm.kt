package robotran.nxjlibrary

import java.io.ByteArrayOutputStream
import java.io.File
import java.io.PrintStream
import java.lang.reflect.InvocationTargetException
import java.net.URLClassLoader
import kotlin.io.path.createTempDirectory

/** A run of the test program at [path] by the JVM, with its own `java` and the library's `lejos`. */
internal class ProgramOnJvm(private val path: String, private val source: String, private val compiler: JdkCompiler) {
    private val name = path.substringAfterLast('/').removeSuffix(".java")
    private val output = ByteArrayOutputStream()
    private val thrown = mutableMapOf<Int, String>()

    val printed: List<String> get() = output.toString().replace("\r", "").removeSuffix("\n").lines()

    /** The simple names of exceptions that left a thread, by the line of the program that threw them. */
    val failures: Map<Int, String> get() = thrown

    fun run() {
        val folder = createTempDirectory("program").toFile()
        try {
            compiler.compile(path, folder.resolve("$name.java").apply { writeText(source) }, folder)
            val places = listOf(folder, compiler.library).map { it.toURI().toURL() }
            URLClassLoader(places.toTypedArray(), null).use { run(it, namesIn(folder)) }
        } finally {
            folder.deleteRecursively()
        }
    }

    private fun namesIn(folder: File): Set<String> =
        folder.list().orEmpty().filter { it.endsWith(".class") }.map { it.removeSuffix(".class") }.toSet()

    private fun run(loader: ClassLoader, names: Set<String>) {
        val before = System.out
        val handler = Thread.getDefaultUncaughtExceptionHandler()
        System.setOut(PrintStream(output, true))
        Thread.setDefaultUncaughtExceptionHandler { _, failure -> fail(failure, names) }
        try {
            val group = ThreadGroup(path)
            Thread(group) {
                try {
                    loader.loadClass(name).getMethod("main", Array<String>::class.java).invoke(null, arrayOf<String>())
                } catch (exception: InvocationTargetException) {
                    fail(exception.targetException, names)
                }
            }.apply { start() }.join(LONGEST)
            val threads = arrayOfNulls<Thread>(MOST_THREADS)
            repeat(group.enumerate(threads)) { index -> threads[index]?.takeUnless { it.isDaemon }?.join(LONGEST) }
        } finally {
            System.setOut(before)
            Thread.setDefaultUncaughtExceptionHandler(handler)
        }
    }

    private fun fail(failure: Throwable, names: Set<String>) {
        val line = failure.stackTrace.firstOrNull { it.className in names }?.lineNumber ?: 0
        synchronized(thrown) { thrown[line] = failure.javaClass.simpleName }
    }

    private companion object {
        const val LONGEST = 10_000L
        const val MOST_THREADS = 50
    }
}
