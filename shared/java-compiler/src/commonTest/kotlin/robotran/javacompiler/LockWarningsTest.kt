package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs

/** A brick's virtual machine locks only for methods that it finds by the object: neither private nor static ones. */
class LockWarningsTest {
    private suspend fun warnings(members: String): List<Diagnostic> = compiled("class Robot {\n$members\n}").warnings

    @Test
    fun `a private synchronized method does not lock`() = runTest {
        val warning = warnings("int count;\n    private synchronized void add() { count++; }").single()
        assertEquals("add", warning.text)
        assertEquals(3, warning.range?.line)
        assertContains(warning.message, "\"private\"")
        assertFalse("IllegalMonitorStateException" in warning.message)
        assertContains(warning.message, "synchronized (this)")
    }

    @Test
    fun `a static synchronized method does not lock`() = runTest {
        val warning = warnings("static int count;\npublic static synchronized void add() { count++; }").single()
        assertContains(warning.message, "\"static\"")
        assertContains(warning.message, "synchronized (LOCK)")
    }

    @Test
    fun `other synchronized methods do lock`() = runTest {
        val members = "int count; synchronized void add() { count++; }\n" +
            "protected final synchronized void take() { count--; }"
        assertEquals(emptyList(), warnings(members))
    }

    @Test
    fun `what needs the lock fails without it`() = runTest {
        for (call in listOf("wait()", "this.wait(10)", "notify()", "notifyAll()")) {
            val method = "private synchronized void next() throws InterruptedException { if (count > 0) $call; }"
            val message = warnings("int count; $method").single().message
            val name = call.removePrefix("this.").substringBefore('(')
            assertContains(message, "\"$name\" in it ends with an IllegalMonitorStateException")
        }
    }

    @Test
    fun `what needs the lock works in a block that locks, and on another object`() = runTest {
        val block = "private synchronized void next() { synchronized (this) { notify(); } }"
        assertFalse("IllegalMonitorStateException" in warnings(block).single().message)
        val other = "private synchronized void next(Object other) { synchronized (other) { other.notify(); } }"
        assertFalse("IllegalMonitorStateException" in warnings(other).single().message)
    }

    @Test
    fun `a call through super locks only if the caller has locked`() = runTest {
        fun overriding(modifiers: String, body: String) =
            "class Robot { static class Counter { int n; synchronized void add() { n++; } }\n" +
                "static class Twice extends Counter { $modifiers void add() { $body } } }"
        val warning = compiled(overriding("", "super.add();")).warnings.single()
        assertEquals("add", warning.text)
        assertContains(warning.message, "\"super\"")
        assertEquals(emptyList(), compiled(overriding("synchronized", "super.add();")).warnings)
        assertEquals(emptyList(), compiled(overriding("", "synchronized (this) { super.add(); }")).warnings)
    }

    @Test
    fun `the warnings are told in all languages`() = runTest {
        val text = "class Robot { private synchronized void next() { notify(); } }"
        for ((messages, word) in listOf(
            JavaMessages.of(Language.GERMAN) to "sperrt",
            JavaMessages.of(Language.SPANISH) to "bloquea",
        )) {
            val result = compiler().withLanguage(messages).compile(listOf(SourceFile("Robot.java", text)), library)
            val warning = assertIs<CompilationResult.Success>(result).warnings.single()
            assertContains(warning.message, word)
            assertContains(warning.message, "IllegalMonitorStateException")
        }
    }
}
