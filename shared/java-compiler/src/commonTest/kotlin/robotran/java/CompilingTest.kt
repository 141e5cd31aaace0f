package robotran.java

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class CompilingTest {
    @Test
    fun `a program becomes a class file with a main method`() = runTest {
        val result = compiled(program("Motor.A.forward(); Thread.sleep(1000);"))
        assertEquals(listOf("Robot"), result.mainClasses)
        assertEquals(setOf("Robot"), result.classes.keys)
        assertEquals(emptyList(), result.warnings)
    }

    @Test
    fun `class files are of the version that leJOS reads`() = runTest {
        val bytes = compiled(program("Motor.A.forward();")).classes.getValue("Robot")
        assertEquals(listOf(0xCA, 0xFE, 0xBA, 0xBE, 0, 3, 0, 45), bytes.take(8).map { it.toInt() and 0xFF })
    }

    @Test
    fun `several files may use each other and each may have a main method`() = runTest {
        val other = JavaSource("tools/Driver.java", "package tools; public class Driver { public static void main(String[] a) { } }")
        val result = compiled("class Robot { public static void main(String[] a) { tools.Driver.main(a); } }", other)
        assertEquals(listOf("Robot", "tools/Driver"), result.classes.keys.toList())
        assertEquals(listOf("Robot", "tools/Driver"), result.mainClasses)
    }

    @Test
    fun `inner and anonymous classes get files of their own`() = runTest {
        val statements = "new Thread() { public void run() { } }.start(); new Inner();"
        val text = program(statements).replace("Robot {", "Robot { static class Inner { }")
        assertEquals(setOf("Robot", "Robot\$1", "Robot\$Inner"), compiled(text).classes.keys)
    }

    @Test
    fun `a program without a main method has no main class`() = runTest {
        assertEquals(emptyList(), compiled("class Robot { void main(String[] a) { } }").mainClasses)
    }

    @Test
    fun `a byte order mark is no part of a program`() = runTest {
        assertTrue(compiled("\uFEFFclass Robot { }").warnings.isEmpty())
        assertEquals(JavaRange(1, 15, 15), mistakes("\uFEFFclass Robot { int a }").single().range.copy(column = 15, endColumn = 15))
    }

    @Test
    fun `the same program gives the same bytes again`() = runTest {
        val text = program("for (int i = 0; i < 10; i++) { Motor.A.setPower(i % 7); }")
        assertContentEquals(compiled(text).classes.getValue("Robot"), compiled(text).classes.getValue("Robot"))
    }

    @Test
    fun `the bytes are the same on every platform`() = runTest {
        val hash = tinyLibrary().entries.fold(0) { hash, (name, bytes) -> 31 * (31 * hash + name.hashCode()) + bytes.contentHashCode() }
        assertEquals(EXPECTED_HASH, hash)
    }

    private companion object {
        /** Of the class files of the tiny library, as the JVM makes them. */
        const val EXPECTED_HASH = -195671223
    }
}
