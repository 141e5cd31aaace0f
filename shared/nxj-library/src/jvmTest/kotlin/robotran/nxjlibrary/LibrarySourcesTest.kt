package robotran.nxjlibrary

import org.eclipse.jdt.core.compiler.batch.BatchCompiler
import java.io.PrintWriter
import java.io.StringWriter
import kotlin.io.path.createTempDirectory
import kotlin.test.Test
import kotlin.test.assertEquals

class LibrarySourcesTest {
    @Test
    fun `all sources compile as Java 6 without a warning`() = assertEquals("", problems("1.6"))

    @Test
    fun `the sources keep to the Java 5 of leJOS NXJ's own tools`() = assertEquals("", problems("1.5"))

    private fun problems(version: String): String {
        val folder = createTempDirectory("nxj").toFile()
        try {
            val empty = folder.resolve("empty").apply { mkdirs() }.path
            val files = library.classNames.filterNot { '$' in it }.mapNotNull { name ->
                sources.source(name)?.let { text ->
                    folder.resolve("$name.java").apply { parentFile.mkdirs() }.also { it.writeText(text) }.path
                }
            }
            val problems = StringWriter()
            val output = PrintWriter(problems)
            val options =
                listOf("-source", version, "-target", version, "-proc:none", "-encoding", "UTF-8", "-d", "none")
            val places = listOf("-bootclasspath", empty, "-classpath", empty)
            BatchCompiler.compile((options + places + files).toTypedArray(), output, output, null)
            return problems.toString().replace(folder.path, "")
        } finally {
            folder.deleteRecursively()
        }
    }
}
