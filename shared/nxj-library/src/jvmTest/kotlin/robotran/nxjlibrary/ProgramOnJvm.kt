package robotran.nxjlibrary

import java.io.File
import java.io.OutputStream
import java.io.PrintStream
import java.lang.reflect.InvocationTargetException
import java.net.URLClassLoader
import javax.tools.ToolProvider
import kotlin.io.path.createTempDirectory

/**
 * What the test program at [path] does when the JDK's own compiler and JVM run it: what each line of it prints, and on
 * which line an exception leaves a thread.
 */
internal class ProgramOnJvm(private val path: String, private val source: String) {
    private val name = path.substringAfterLast('/').removeSuffix(".java")
    private val prints = mutableMapOf<Int, MutableList<String>>()
    private val failures = mutableMapOf<Int, String>()

    /** The printed lines by the line of the program, and the simple names of exceptions. */
    fun run(): Pair<Map<Int, List<String>>, Map<Int, String>> {
        val folder = createTempDirectory("program").toFile()
        try {
            compile(folder)
            val places = listOf(folder, folder.resolve("library")).map { it.toURI().toURL() }
            URLClassLoader(places.toTypedArray(), null).use { run(it) }
            return prints to failures
        } finally {
            folder.deleteRecursively()
        }
    }

    private fun compile(folder: File) {
        val file = folder.resolve("$name.java").apply { writeText(source) }
        val library = folder.resolve("library")
        for ((name, bytes) in library()) {
            library.resolve("$name.class").apply { parentFile.mkdirs() }.writeBytes(bytes)
        }
        val options =
            arrayOf("-nowarn", "-Xlint:none", "--release", "8", "-cp", library.path, "-d", folder.path, file.path)
        val problems = java.io.ByteArrayOutputStream()
        check(ToolProvider.getSystemJavaCompiler().run(null, problems, problems, *options) == 0) { "$path: $problems" }
    }

    private fun run(loader: ClassLoader) {
        val before = System.out
        val handler = Thread.getDefaultUncaughtExceptionHandler()
        System.setOut(PrintStream(LinesByPlace(loader), true))
        Thread.setDefaultUncaughtExceptionHandler { _, thrown -> fail(thrown, loader) }
        try {
            val group = ThreadGroup(path)
            Thread(group) {
                try {
                    loader.loadClass(name).getMethod("main", Array<String>::class.java).invoke(null, arrayOf<String>())
                } catch (exception: InvocationTargetException) {
                    fail(exception.targetException, loader)
                }
            }.apply { start() }.join(LONGEST)
            waitFor(group)
        } finally {
            System.setOut(before)
            Thread.setDefaultUncaughtExceptionHandler(handler)
        }
    }

    /** The library's classes that the JVM does not have itself. */
    private fun library() = robotran.nxjlibrary.library.classFiles.filterKeys { it.startsWith("lejos/") }

    private fun waitFor(group: ThreadGroup) {
        val threads = arrayOfNulls<Thread>(MOST_THREADS)
        repeat(group.enumerate(threads)) { index -> threads[index]?.takeUnless { it.isDaemon }?.join(LONGEST) }
    }

    private fun fail(thrown: Throwable, loader: ClassLoader) {
        val names = namesIn(loader)
        val line = thrown.stackTrace.firstOrNull { it.className in names }?.lineNumber ?: 0
        synchronized(failures) { failures[line] = thrown.javaClass.simpleName }
    }

    private fun namesIn(loader: ClassLoader): Set<String> =
        File((loader as URLClassLoader).urLs.first().toURI()).list().orEmpty().filter { it.endsWith(".class") }
            .map { it.removeSuffix(".class") }.toSet()

    /** Adds each line that is printed to those of the innermost line of the program that is being executed. */
    private inner class LinesByPlace(loader: ClassLoader) : OutputStream() {
        private val names = namesIn(loader)
        private val line = StringBuilder()

        override fun write(octet: Int) {
            if (octet.toChar() != '\n') {
                line.append(octet.toChar())
                return
            }
            val place = StackWalker.getInstance().walk { frames ->
                frames.filter { it.className in names }.findFirst().map { it.lineNumber }.orElse(0)
            }
            prints.getOrPut(place) { mutableListOf() } += line.toString()
            line.clear()
        }
    }

    private companion object {
        const val LONGEST = 10_000L
        const val MOST_THREADS = 50
    }
}
