package robotran.nxjlibrary

import org.eclipse.jdt.core.compiler.batch.BatchCompiler
import java.io.File
import java.io.PrintWriter
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.io.path.createTempDirectory
import kotlin.test.Test
import kotlin.test.assertEquals

/** The script that tells how much of another class library is there. */
class CompareApiTest {
    @Test
    fun `classes and members are counted by package, and those that are missing or more are told`() = inFolder {
        val original = compiled(
            "original",
            """
            package a;
            public class Car extends Thing {
                public int doors;
                int wheels;
                public Car(int doors) { this.doors = doors; }
                public void drive() { }
                protected void drive(float by) { }
                void push() { }
                public static class Lamp { public Lamp() { } }
                static class Dark { public void off() { } }
            }
            """,
            "package a; public class Thing { public void name() { } }",
            "package b; public interface Flies { void fly(); }",
        )
        val ours = compiled(
            "ours",
            """
            package a;
            public class Car extends Thing {
                public int doors;
                public Car(int doors) { this.doors = doors; }
                public void honk() { }
            }
            """,
            "package a; public class Thing { public void drive() { } public void name() { } }",
            "package c; public class New { }",
        )
        val counts = listOf(
            "| `a` | 3 | 2 | 7 | 5 | 71 | 0 | 2 |",
            "| `b` | 1 | 0 | 1 | 0 | 0 | 0 | 0 |",
            "| `c` | 0 | 0 | 0 | 0 | 100 | 1 | 1 |",
            "| all | 4 | 2 | 8 | 5 | 62 | 1 | 3 |",
        )
        val told = listOf(
            "missing a.Car: drive(F)",
            "missing class a.Car\$Lamp",
            "more a.Car: honk()",
            "more a.Thing: drive()",
            "missing class b.Flies",
            "more class c.New",
        )
        assertEquals(HEAD + counts + told, compared(original, ours))
        assertEquals(HEAD + counts, compared("--table", jar(original), jar(ours)))
    }

    private fun inFolder(test: Places.() -> Unit) {
        val folder = createTempDirectory("compare").toFile()
        try {
            Places(folder).test()
        } finally {
            folder.deleteRecursively()
        }
    }

    private class Places(private val folder: File) {
        fun compiled(name: String, vararg classes: String): String {
            val sources = classes.mapIndexed { index, text ->
                val file = checkNotNull(CLASS.find(text)).groupValues[1] + ".java"
                folder.resolve("$name-$index/$file").apply { parentFile.mkdirs() }.also { it.writeText(text) }.path
            }
            val place = folder.resolve(name).path
            val output = PrintWriter(System.out)
            check(BatchCompiler.compile((listOf("-8", "-d", place) + sources).toTypedArray(), output, output, null))
            return place
        }

        fun jar(place: String): String {
            val classes = File(place)
            val jar = File("$place.jar")
            ZipOutputStream(jar.outputStream()).use { zip ->
                classes.walk().filter { it.isFile }.forEach { file ->
                    zip.putNextEntry(ZipEntry(file.relativeTo(classes).invariantSeparatorsPath))
                    zip.write(file.readBytes())
                }
            }
            return jar.path
        }

        fun compared(vararg arguments: String): List<String> {
            val script = folder.resolve("CompareApi.java").apply { writeText(comparison.values.single()) }
            val java = File(System.getProperty("java.home"), "bin/java").path
            val process = ProcessBuilder(listOf(java, script.path) + arguments).redirectErrorStream(true).start()
            return process.inputStream.bufferedReader().readLines()
        }
    }

    private companion object {
        val CLASS = Regex("public (?:class|interface) (\\w+)")
        val HEAD = listOf(
            "| package | classes | there | members | there | % | more classes | more members |",
            "|---|---|---|---|---|---|---|---|",
        )
    }
}
