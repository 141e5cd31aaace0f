package robotran.cli

import java.io.File
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The test classpath contains the command line's classpath. */
class ClasspathTest {
    @Test
    fun `the command line starts without Compose and Skia`() {
        val classpath = System.getProperty("java.class.path").split(File.pathSeparator)
        assertTrue(classpath.any { "clikt" in it }, "$classpath")
        val graphics =
            listOf("androidx/compose", "org.jetbrains.compose", "org.jetbrains.skiko", "shared/ui", "shared/workshop")
        assertEquals(emptyList(), classpath.filter { entry -> graphics.any { it in entry.replace('\\', '/') } })
        for (name in listOf("androidx.compose.runtime.Composer", "org.jetbrains.skia.Image")) {
            assertTrue(runCatching { Class.forName(name) }.isFailure, name)
        }
    }
}
