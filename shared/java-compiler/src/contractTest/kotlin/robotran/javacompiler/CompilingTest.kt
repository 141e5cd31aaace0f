package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.language.source.SourceRange
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotEquals
import kotlin.test.assertNull
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
        val other =
            SourceFile(
                "tools/Driver.java",
                "package tools; public class Driver { public static void main(String[] a) { } }",
            )
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
    fun `a program without a main method is told where it should be`() = runTest {
        val none = compiled("// class\nclass Robot { }")
        assertEquals(emptyList(), none.mainClasses)
        assertEquals(SourceRange(2, 7, 12) to "Robot", none.missingMain?.let { it.range to it.text })
        val wrong = compiled("class Robot {\nvoid Main(String[] a) { } }").missingMain
        assertEquals(SourceRange(2, 6, 10) to "Main", wrong?.let { it.range to it.text })
        assertNotEquals(none.missingMain?.message, wrong?.message)
        assertNull(compiled(program("")).missingMain)
    }

    @Test
    fun `no sources are no program`() = runTest {
        assertNull(assertIs<CompilationResult.Success>(compiler().compile(emptyList(), library)).missingMain)
    }

    @Test
    fun `a library is read again when it is another one`() = runTest {
        val source = listOf(SourceFile("Robot.java", "class Robot { Helper helper; }"))
        val helper = compiled("class Helper { }").classes
        assertIs<CompilationResult.Success>(compiler().compile(source, library + helper))
        assertIs<CompilationResult.Failure>(compiler().compile(source, library))
    }

    @Test
    fun `a byte order mark is no part of a program`() = runTest {
        assertTrue(compiled("\uFEFFclass Robot { }").warnings.isEmpty())
        assertEquals(
            SourceRange(1, 15, 15),
            diagnostics("\uFEFFclass Robot { int a }").single().range?.copy(column = 15, endColumn = 15),
        )
    }

    @Test
    fun `the same program gives the same bytes again`() = runTest {
        val text = program("for (int i = 0; i < 10; i++) { Motor.A.setPower(i % 7); }")
        assertContentEquals(compiled(text).classes.getValue("Robot"), compiled(text).classes.getValue("Robot"))
    }
}
