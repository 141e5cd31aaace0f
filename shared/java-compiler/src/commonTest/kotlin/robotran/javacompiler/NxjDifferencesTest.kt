package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.javacompiler.diagnose.missingInNxj
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.nxjlibrary.NxjDifference
import robotran.nxjlibrary.NxjDifferences
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** What leJOS NXJ lacks is refused true to the brick, with what to write instead, and accepted if forgiving. */
class NxjDifferencesTest {
    @Test
    fun `every difference is refused true to the brick and accepted if forgiving`() = runTest {
        for (difference in NxjDifferences.all) {
            val text = programWith(difference)
            assertIs<CompilationResult.Failure>(compileForNxt(text), text)
            val forgiving = compileForNxt(text, isForgiving = true)
            assertIs<CompilationResult.Success>(forgiving, "$text\n$forgiving")
        }
    }

    @Test
    fun `the mistake says what to write instead`() = runTest {
        for ((statement, code) in INSTEAD) {
            val described = nxtDiagnostic(statement)
            assertAdvice("Write $code.", described)
            val text = nxtProgram(statement)
            assertIs<CompilationResult.Success>(compileForNxt(text, isForgiving = true), text)
        }
    }

    @Test
    fun `a constructor is told with those that are there`() = runTest {
        val described = nxtDiagnostic("Object o = new EmptyStackException(\"late\");")
        assertContains(described.message, "new EmptyStackException()")
    }

    @Test
    fun `no loop with a colon goes through a Vector`() = runTest {
        val described = nxtDiagnostic("Vector<String> v = null; for (String s : v) LCD.clear();")
        assertContains(described.message, JavaMessages.of(Language.ENGLISH).onlyArraysAndLists())
        assertContains(described.message, "i < vector.size()")
    }

    @Test
    fun `a misspelled name is not corrected to what leJOS NXJ lacks`() = runTest {
        assertEquals(null, nxtDiagnostic("LinkedList<String> l = null; l.addlast(null);").fix)
    }

    @Test
    fun `a class of the program need not have what leJOS NXJ lacks`() = runTest {
        compiledForNxt(
            "import java.util.*;\nclass Robot {\npublic static void main(String[] a) { new Row().offer(3); }\n" +
                "static class Row extends LinkedList<Integer> { public void offer(int i) { add(i); } }\n}\n",
        )
    }

    @Test
    fun `a compiled use is told in one text`() {
        assertEquals(
            "\"LinkedList\" has no method \"getFirst\". Write list.get(0).",
            missingInNxj("LinkedList", "getFirst()Ljava/lang/Object;", JavaMessages.of(Language.ENGLISH)),
        )
        assertEquals(
            "A \"HashSet\" is not made of (int, String[]).",
            missingInNxj("HashSet", "<init>(I[Ljava/lang/String;)V", JavaMessages.of(Language.ENGLISH)),
        )
    }

    /** A program that uses what [difference] is about. */
    private fun programWith(difference: NxjDifference): String {
        val owner = difference.owner.replace('/', '.')
        val types = difference.member.substringAfter('(', "").substringBefore(')')
        val arguments = PARAMETER.findAll(types).joinToString { argument(it.value) }
        val use = when {
            difference.name == "<init>" -> "new $owner($arguments);"
            '(' in difference.member -> "o.${difference.name}($arguments);"
            else -> "System.out.println(o.${difference.name});"
        }
        if (owner in WITH_PROTECTED_MEMBERS) {
            return "class Robot extends $owner {\nRobot() { super(false, 0f, 0f); }\nvoid use(Robot o) { $use }\n}\n"
        }
        return nxtProgram(if (difference.name == "<init>") use else "$owner o = null; $use")
    }

    private fun argument(descriptor: String): String = when (descriptor) {
        "I" -> "7"
        "J" -> "7L"
        "F" -> "7.5f"
        "D" -> "7.5"
        "Z" -> "true"
        "[B" -> "new byte[2]"
        "[I" -> "new int[2]"

        else -> "(${descriptor.trimStart('[').drop(1).dropLast(1).replace('/', '.')}${"[]".repeat(
            descriptor.count { it == '[' },
        )}) null"
    }

    private companion object {
        val PARAMETER = Regex("""\[*(?:L[^;]+;|[ZBCSIJFD])""")

        val WITH_PROTECTED_MEMBERS = setOf("lejos.robotics.navigation.Move")

        /** Statements with a member that leJOS NXJ lacks, and the code to write instead. */
        val INSTEAD = listOf(
            "new LinkedList<String>().addLast(null);" to "list.add(element)",
            "new LinkedList<String>().addFirst(null);" to "list.add(0, element)",
            "new LinkedList<String>().removeFirst();" to "list.remove(0)",
            "new LinkedList<String>().getLast();" to "list.get(list.size() - 1)",
            "new Vector<String>().get(0);" to "vector.elementAt(index)",
            "new Stack<String>().contains(null);" to "vector.indexOf(element) >= 0",
            "new Vector<String>().add(null);" to
                "vector.addElement(element) or vector.insertElementAt(element, index)",
            "new Queue<String>().offer(null);" to "queue.push(element)",
            "new Queue<String>().poll();" to "queue.pop()",
            "new Hashtable<String, String>().containsKey(null);" to "table.get(key) != null",
            "boolean b = \"ab\".endsWith(\"b\");" to "text.startsWith(end, text.length() - end.length())",
            "int s = Integer.signum(3);" to "Math.signum(number)",
            "new Random().setSeed(3);" to "new Random(seed)",
            "Runtime.getRuntime().gc();" to "System.gc()",
            "Button.waitForAnyEvent();" to "Button.waitForAnyEvent(0)",
            "NXT.exit(0);" to "System.exit(0)",
        )
    }
}
