package robotran.tinyvm

import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.messages.TinyVmMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class QuirkTest {
    @Test
    fun `a brick divides by sixteen bits only`() {
        val body = "int divisor = 70000; show(100000 / divisor);"
        assertEquals(listOf(22), shownBy(body))
        assertEquals(listOf(1), shownBy(body, mode = TinyVmMode.FORGIVING))
        assertEquals(
            listOf(TinyVmMessages.of(Language.ENGLISH).quirkEffect(Quirk.DIVISOR_OF_16_BITS)),
            ran(body).run.warnings.map { it.message },
        )
        assertEquals(
            listOf(TinyVmMessages.of(Language.ENGLISH).quirkWarning(Quirk.DIVISOR_OF_16_BITS)),
            ran(body, mode = TinyVmMode.FORGIVING).run.warnings.map { it.message },
        )
    }

    @Test
    fun `each quirk that bites is explained once with its line`() {
        for ((quirk, code) in BITING) {
            for (mode in TinyVmMode.entries) {
                val body = "for (int again = 0; again < 2; again++) {\n$code\n}"
                val warnings = ran(body, MEMBERS, mode).run.warnings
                val expected = if (mode == TinyVmMode.BRICK) {
                    TinyVmMessages.of(Language.ENGLISH).quirkEffect(quirk)
                } else {
                    TinyVmMessages.of(Language.ENGLISH).quirkWarning(quirk)
                }
                assertEquals(listOf(5), warnings.map { it.sourceLine }, "$quirk $mode")
                assertTrue(warnings.single().message.startsWith(expected), warnings.toString())
            }
        }
        assertEquals(Quirk.entries.toSet(), BITING.keys)
    }

    @Test
    fun `a full memory tells what the program itself takes`() {
        val ran = ran("try { while (true) new Object(); } catch (OutOfMemoryError full) { show(1); }")
        val said = ran.run.warnings.single().message
        assertTrue(Regex("Of its 13888 bytes, the program itself takes about \\d{3}\\.").containsMatchIn(said), said)
    }

    @Test
    fun `a brick looks at sixteen bits of an index`() {
        val body =
            "int[] a = {5, 6}; int index = 65537; try { show(a[index]); } catch (ArrayIndexOutOfBoundsException e) { " +
                "show(1); }"
        assertEquals(listOf(6), shownBy(body))
        assertEquals(listOf(1), shownBy(body, mode = TinyVmMode.FORGIVING))
    }

    @Test
    fun `a large character is negative on a brick`() {
        val body = "int code = 40000; char c = (char) code; show(c / 100);"
        assertEquals(listOf(-255), shownBy(body))
        assertEquals(listOf(400), shownBy(body, mode = TinyVmMode.FORGIVING))
    }

    @Test
    fun `everything passes for an interface on a brick`() {
        val body = "Object o = \"x\"; show(o instanceof Named); show(o instanceof Thread); show(null instanceof Named);"
        val members = "interface Named { int name(); }"
        assertEquals(listOf(1, 0, 0), shownBy(body, members))
        assertEquals(listOf(0, 0, 0), shownBy(body, members, TinyVmMode.FORGIVING))
    }

    @Test
    fun `a method that an object does not have is an error that can be caught`() = assertEquals(
        listOf(3),
        shownBy(
            "Object o = \"x\"; try { ((Named) o).name(); } catch (NoSuchMethodError e) { show(3); }",
            "interface Named { int " +
                "name(); }",
        ),
    )

    @Test
    fun `arrays of more than 511 elements do not fit a brick`() {
        val body = "try { show(new int[512].length); } catch (OutOfMemoryError e) { show(1); }"
        assertEquals(listOf(1), shownBy(body))
        assertEquals(listOf(512), shownBy(body, mode = TinyVmMode.FORGIVING))
    }

    @Test
    fun `a brick never gives memory back`() {
        val body = "for (int i = 0; i < 100000; i++) { int[] a = new int[100]; a[0] = i; } show(7);"
        val failed = assertIs<ProgramStatus.Failed>(ran(body).status)
        assertTrue("OutOfMemoryError" in failed.failure.message, failed.failure.message)
        assertEquals(listOf(7), shownBy(body, mode = TinyVmMode.FORGIVING))
    }

    @Test
    fun `what is still used survives the collection`() = assertEquals(
        listOf(499500 / 100),
        shownBy(
            "Node first = null; for (int i = 0; i < 1000; i++) { first = new Node(i, first); for (int j = 0; j < 50; " +
                "j++) { int[] a " +
                "= new int[50]; } }" +
                "int sum = 0; for (Node n = first; n != null; n = n.next) sum += n.value; show(sum / 100);",
            "static class Node { int value; Node next; Node(int value, Node next) { this.value = value; this.next = " +
                "next; } " +
                "}",
            TinyVmMode.FORGIVING,
        ),
    )

    @Test
    fun `a heap full of what is used is an error in forgiving mode too`() {
        val body =
            "Object[] all = new Object[5000]; try { for (int i = 0; i < 5000; i++) all[i] = new int[500]; } catch " +
                "(OutOfMemoryError e) { show(1); }"
        assertEquals(listOf(1), shownBy(body, mode = TinyVmMode.FORGIVING))
    }

    @Test
    fun `endless recursion is an error that can be caught`() = assertEquals(
        listOf(1),
        shownBy(
            "try { deeper(1); } catch (StackOverflowError e) { show(1); }",
            "static int deeper(int x) { " +
                "return deeper(x + 1); }",
        ),
    )

    @Test
    fun `a brick has room for 211 calls inside each other, and for fewer with many variables`() {
        val members = "static int depth; static void deeper() { depth++; deeper(); } " +
            "static void wider(int a, int b, int c, int d, int e, int f, int g, int h) { " +
            "depth++; wider(a, b, c, d, e, f, g, h); }"

        fun depthOf(call: String, mode: TinyVmMode) =
            shownBy("try { $TRY $call; $CATCH } catch (StackOverflowError e) { show(depth); }", members, mode).single()
        assertEquals(210, depthOf("deeper()", TinyVmMode.BRICK))
        assertEquals(254, depthOf("deeper()", TinyVmMode.FORGIVING))
        assertEquals(60, depthOf("wider(1, 2, 3, 4, 5, 6, 7, 8)", TinyVmMode.BRICK))
        assertEquals(254, depthOf("wider(1, 2, 3, 4, 5, 6, 7, 8)", TinyVmMode.FORGIVING))
    }

    @Test
    fun `a full memory leaves less room for calls`() = assertEquals(
        listOf(1),
        shownBy(
            "try { while (true) new Object(); } catch (OutOfMemoryError full) { } " +
                "try { $TRY deeper(); $CATCH } catch (StackOverflowError e) { show(depth < 10); }",
            "static int depth; static void deeper() { depth++; deeper(); }",
        ),
    )

    @Test
    fun `a brick creates arrays of three dimensions only one after the other`() {
        val body = "try { show(new int[2][3][4][1].length); } catch (OutOfMemoryError e) { show(0); } " +
            "try { show(new int[2][3][].length); } catch (OutOfMemoryError e) { show(0); } " +
            "show(new int[1][3][4].length); show(new int[2][3].length); show(new int[2][][].length);"
        assertEquals(listOf(0, 0, 1, 2, 2), shownBy(body))
        assertEquals(listOf(2, 2, 1, 2, 2), shownBy(body, mode = TinyVmMode.FORGIVING))
    }

    @Test
    fun `a large character in an array or a field is negative on a brick`() {
        val body =
            "char[] letters = {'\\uffff'}; one = '\\uffff'; Program two = new Program(); two.other = '\\uffff'; " +
                "show(letters[0] / 100); show(one / 100); show(two.other / 100); show(\"\\ufffe\".charAt(0) / 2);"
        val members = "static char one; char other;"
        assertEquals(listOf(0, 0, 0, -1), shownBy(body, members))
        assertEquals(listOf(655, 655, 655, 32767), shownBy(body, members, TinyVmMode.FORGIVING))
    }

    @Test
    fun `a brick initializes a superclass only when it is used itself`() {
        val body = "Late.touch(); show(order); new Late(); show(order);"
        val members = "static int order; static class Early { static { order = order * 10 + 1; } } " +
            "static class Late extends Early { static { order = order * 10 + 2; } static void touch() { } }"
        assertEquals(listOf(2, 21), shownBy(body, members))
        assertEquals(listOf(12, 12), shownBy(body, members, TinyVmMode.FORGIVING))
    }

    @Test
    fun `a private method that is called with the lock needs no explanation`() = assertEquals(
        emptyList(),
        ran(
            "new Program().outer();",
            "synchronized void outer() { inner(); } private synchronized void inner() { notify(); }",
        ).run.warnings,
    )

    @Test
    fun `a static method without a lock is explained where it is called`() {
        val body = "show(1);\nlocked();"
        val warning = ran(body, "static synchronized void locked() { }").run.warnings.single()
        assertEquals(5, warning.sourceLine)
        assertEquals(TinyVmMessages.of(Language.ENGLISH).quirkEffect(Quirk.UNLOCKED_METHOD), warning.message)
    }

    @Test
    fun `a try is not for a statement before it at which a variable has no value yet`() {
        val body = "try { unknown(-1); } catch (RuntimeException e) { show(1); } unknown(2);"
        val member = "static void unknown(int way) { int number; " +
            "if (way > 0) { number = way; } else { throw new RuntimeException(); } " +
            "try { throw new RuntimeException(); } catch (RuntimeException e) { show(number); } }"
        for (mode in TinyVmMode.entries) assertEquals(listOf(1, 2), shownBy(body, member, mode), "$mode")
    }

    private companion object {
        /** What a brick throws first if it has no array for a larger stack. */
        const val TRY = "try {"
        const val CATCH = "} catch (OutOfMemoryError noArray) { }"

        const val MEMBERS =
            "interface Named { int name(); } static class Early { static int[] early = {1}; } " +
                "static class Late extends Early { static int[] late = {2}; }"

        val BITING: Map<Quirk, String> = mapOf(
            Quirk.DIVISOR_OF_16_BITS to "int divisor = 70000; show(100000 / divisor);",
            Quirk.INDEX_OF_16_BITS to
                "int[] a = {5, 6}; int index = 65537; try { show(a[index]); } catch (ArrayIndexOutOfBoundsException " +
                "e) { show(1); }",
            Quirk.SIGNED_CHARACTER to "int code = 40000; show((char) code);",
            Quirk.UNCHECKED_INTERFACE to "Object o = \"x\"; show(o instanceof Named);",
            Quirk.LONG_ARRAY to "try { show(new int[512].length); } catch (OutOfMemoryError e) { show(1); }",
            Quirk.HEAP_FULL to
                "try { for (int i = 0; i < 100; i++) { int[] a = new int[100]; } } catch (OutOfMemoryError e) { " +
                "show(1); }",
            Quirk.NOT_A_NUMBER to "float none = again - again; none = none / none; show(none < 1f);",
            Quirk.JOIN_DOES_NOTHING to "Thread thread = new Thread() { public void run() { } }; thread.join();",
            Quirk.UNLOCKED_METHOD to
                "new Object() { void call() { locked(); } private synchronized void locked() { show(1); } }.call();",
            Quirk.DEEP_ARRAY to
                "try { show(new int[2][2][2].length); } catch (OutOfMemoryError e) { show(1); }",
            Quirk.DEEP_CALLS to
                "try { new Object() { void deeper() { deeper(); } }.deeper(); } catch (StackOverflowError e) { show(1); }",
            Quirk.LATE_INITIALIZER to "show(Late.late[0]);",
            Quirk.EARLY_HANDLER to
                "try { int[] a = new int[1]; a[1] = 2; try { show(1); } catch (RuntimeException e) { show(2); } } " +
                "catch (RuntimeException e) { show(3); }",
            Quirk.NEGATIVE_TIME to "try { Thread.sleep(-5); } catch (IllegalArgumentException e) { show(1); }",
            Quirk.NEGATIVE_LONG to "long n = -5; float f = n; show(f > 0);",
            Quirk.UNCHECKED_ELEMENT to
                "Object[] a = new String[1]; try { a[0] = new Object(); show(1); } catch (ClassCastException e) { show(2); }",
            Quirk.LOST_EXCEPTION to
                "try { int[] a = new int[-1]; } catch (OutOfMemoryError e) { show(e == null); }",
        )
    }
}
