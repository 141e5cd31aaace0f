package robotran.java

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

class MistakesTest {
    private suspend fun mistake(statements: String) = mistakes(program(statements)).first()

    private suspend fun assertHint(statements: String, hint: String) = assertContains(assertNotNull(mistake(statements).hint), hint)

    private suspend fun mended(statements: String): String {
        val fix = assertNotNull(mistake(statements).fix)
        val lines = program(statements).lines().toMutableList()
        val line = lines[fix.range.line - 1]
        lines[fix.range.line - 1] = line.substring(0, fix.range.column - 1) + fix.replacement + line.substring(fix.range.endColumn - 1)
        return lines.joinToString("\n").lines().drop(3).dropLast(3).joinToString("\n")
    }

    @Test
    fun `a missing semicolon is put in where it belongs`() = runTest {
        assertEquals("Put a \";\" at the end of this statement.", mistake("int x = 1\nint y = 2;").message)
        assertEquals("int x = 1;\nint y = 2;", mended("int x = 1\nint y = 2;"))
    }

    @Test
    fun `a missing bracket is put in where it belongs`() = runTest {
        assertEquals("if (args.length() > 0) { }".replace("args.length()", "1"), mended("if (1 > 0 { }"))
    }

    @Test
    fun `a misspelt name is told with the one that is near`() = runTest {
        assertEquals("Motor.A.forward();", mended("Motor.A.foward();"))
        assertEquals("Motor.A.forward();", mended("Moter.A.forward();"))
        assertEquals("int speed = 3; Motor.A.setPower(speed);", mended("int speed = 3; Motor.A.setPower(sped);"))
    }

    @Test
    fun `a missing import is told with its line`() = runTest {
        val mistake = mistakes("class Robot { void go() { Motor.A.forward(); } }").single()
        assertEquals("import josx.platform.rcx.*;\n", mistake.fix?.replacement)
    }

    @Test
    fun `what the brick does not have is told with what it has instead`() = runTest {
        assertHint("System.out.println(3);", "LCD.showNumber")
        assertHint("Runnable r;", "extends Thread")
        assertHint("ArrayList list;", "Vector")
        assertHint("java.util.Scanner input;", "buttons")
        assertHint("Integer.parseInt(\"3\");", "numbers from texts")
        assertHint("String.format(\"\", args);", "LCD.showNumber")
    }

    @Test
    fun `newer Java is told with the older way`() = runTest {
        assertHint("java.util.Vector<String> names;", "<...>")
        assertHint("for (String arg : args) { }", "Count instead")
        assertHint("Thread t = () -> { };", "new Thread()")
        assertHint("Integer number = 3;", "new Integer")
        assertHint("var speed = 3;", "type")
        assertContains(assertNotNull(mistakes("class Robot { enum Color { RED } }").first().hint), "static final int")
        assertContains(mistakes("class Robot { @Override public String toString() { return null; } }").first().message, "annotations")
    }

    @Test
    fun `what the brick's virtual machine does not do is refused`() = runTest {
        assertContains(mistake("switch (3) { case 1: break; }").message, "switch")
        assertHint("long end = System.currentTimeMillis() + 5;", "(int)")
        assertContains(mistake("float x = 1; x = x % 2;").message, "%")
        assertContains(mistake("Object o = null; int[] all = (int[]) o;").message, "array")
        assertContains(mistake("Object o = Robot.class;").message, ".class")
    }

    @Test
    fun `one mistake is told once`() = runTest {
        assertEquals(1, mistakes("import java.util.ArrayList;\nclass Robot {\nArrayList a;\nArrayList b;\n}").size)
        assertEquals(1, mistakes(program("int x = 1\nMotor.A.foo();")).size)
    }

    @Test
    fun `a single equals sign in a condition becomes two`() = runTest {
        assertEquals("int x = 1; if (x == 1) { }", mended("int x = 1; if (x = 1) { }"))
    }

    @Test
    fun `types that do not fit come with a way to make them fit`() = runTest {
        assertEquals("float x = 1.5f;", mended("float x = 1.5;"))
        assertHint("int x = Math.random() * 3;", "(int)")
    }

    @Test
    fun `an exception that nothing takes care of is passed on`() = runTest {
        assertHint("} void go() { Thread.sleep(10);", "throws InterruptedException")
    }
}
