package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertContains

/** Java features of a computer that the brick does not have. */
class UnsupportedOnBrickTest {
    private suspend fun assertHint(statements: String, hint: String) = assertContains(
        diagnostic(statements).message,
        hint,
    )

    @Test
    fun `classes that the brick does not have are told with what it has instead`() = runTest {
        assertHint("Runnable r;", "extends Thread")
        assertHint("ArrayList list;", "Vector")
        assertHint("List list;", "Vector")
        assertHint("Map map;", "Vector")
        assertHint("java.util.Scanner input;", "buttons")
        assertHint("Double d;", "float itself")
        assertHint("char d = Character.toUpperCase('c');", "char")
        assertHint("JFrame frame;", "LCD")
        assertHint("UltrasonicSensor eye;", "josx.platform.rcx")
        assertContains(
            diagnostics("import lejos.nxt.Motor;\nclass Robot { }").first().message,
            "josx.platform.rcx",
        )
        assertContains(
            diagnostics("import java.util.ArrayList;\nclass Robot { }").first().message,
            "Vector",
        )
    }

    @Test
    fun `methods that the brick does not have are told with what it has instead`() = runTest {
        assertHint("System.out.println(3);", "LCD.showNumber")
        assertHint("println(3);", "LCD.showNumber")
        assertHint("sleep(100);", "Thread.sleep")
        assertHint("Integer.parseInt(\"3\");", "numbers from texts")
        assertHint("String.format(\"\", args);", "LCD.showNumber")
        assertHint("String s = String.valueOf(3);", "Integer.toString(number)")
        for (call in listOf(
            "substring(1)",
            "equalsIgnoreCase(\"b\")",
            "indexOf(\"b\")",
            "trim()",
            "toUpperCase()",
            "isEmpty()",
        )) {
            assertHint("\"a\".$call;", "charAt()")
        }
        assertHint("new java.util.Vector().add(null);", "addElement()")
        assertHint("new java.util.Hashtable().containsKey(null);", "get() gives null")
        assertHint("System.nanoTime();", "currentTimeMillis()")
        assertHint("System.arraycopy(null, 0, null, 0, 1);", "for")
    }

    @Test
    fun `a thread is a class of its own`() = runTest {
        assertHint("Thread t = new Thread();", "extends Thread")
    }

    @Test
    fun `newer Java is told with the older way`() = runTest {
        assertHint("java.util.Vector<String> names;", "<...>")
        assertHint("for (String arg : args) { }", "Count instead")
        assertHint("Thread t = () -> { };", "new Thread()")
        assertHint("Integer number = 3;", "new Integer")
        assertHint("int number = new Integer(3);", "new Integer")
        assertHint("new java.util.Vector().addElement(5);", "new Integer")
        assertHint("Integer one = null; int two = one + 1;", "new Integer")
        assertHint("var speed = 3;", "Write the type")
        assertHint("assert 1 > 2;", "Use \"if\"")
        assertHint("int x = 1_000;", "digits only")
        assertHint("String s = \"\"\"\nhello\n\"\"\";", "on one line")
        assertContains(
            diagnostics("class Robot { enum Color { RED } }").first().message,
            "static final int",
        )
        assertContains(
            diagnostics("class Robot { @Override public String toString() { return null; } }").first().message,
            "annotations",
        )
        assertContains(diagnostics("class Robot { void all(int... n) { } }").first().message, "array")
        assertContains(
            diagnostics("import static java.lang.Math.*;\nclass Robot { }").first().message,
            "Import the class",
        )
    }

    @Test
    fun `what the brick's virtual machine does not do is refused`() = runTest {
        assertHint("switch (3) { case 1: break; }", "else if")
        assertHint("long end = System.currentTimeMillis() + 5;", "(int)")
        assertHint("float x = 1; x = x % 2;", "whole number of times")
        assertHint("Object o = null; int[] all = (int[]) o;", "int[]")
        assertHint("Object o = null; boolean b = o instanceof int[];", "int[]")
        assertHint("Object o = Robot.class;", "instanceof")
    }
}
