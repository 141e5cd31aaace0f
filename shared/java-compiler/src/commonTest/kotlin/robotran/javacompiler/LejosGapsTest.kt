package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.language.source.Diagnostic
import robotran.languagesupport.SourceFile
import robotran.lejoslibrary.LejosDifference
import robotran.lejoslibrary.LejosDifferences
import robotran.lejoslibrary.LejosRemedy
import robotran.tinyvm.config.LejosVersion
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull

/** Refuses what leJOS on a real brick lacks, and says what to write instead. */
class LejosGapsTest {
    private suspend fun compileFor(version: LejosVersion, text: String): CompilationResult = compiler().compile(
        listOf(SourceFile("Robot.java", text)),
        library,
        LejosDifferences.all.filterNot { it.isIn(version) },
    )

    private suspend fun diagnostics(statements: String): List<Diagnostic> =
        assertIs<CompilationResult.Failure>(compileFor(LejosVersion.V3_0, program(statements)), statements).diagnostics

    @Test
    fun `each exception that leJOS makes without a text is refused with one`() = runTest {
        val withoutText = LejosDifferences.all.filter { it.instead == LejosRemedy.EXCEPTION_WITHOUT_TEXT }
        assertEquals(18, withoutText.size)
        for (difference in withoutText) {
            val name = difference.owner.replace('/', '.')
            val diagnostic = diagnostics("Throwable t = new $name(\"late\");").single()
            assertEquals("new $name(\"late\")", diagnostic.text)
            assertContains(diagnostic.message, name.substringAfterLast('.'))
            assertContains(diagnostic.message, "new ${name.substringAfterLast('.')}()")
            assertIs<CompilationResult.Success>(
                compileFor(LejosVersion.V3_0, program("Throwable t = new $name();")),
                name,
            )
        }
    }

    @Test
    fun `a subclass cannot give such an exception a text either`() = runTest {
        val text = "class Robot extends IllegalStateException { Robot() { super(\"late\"); } }"
        val rejected = assertIs<CompilationResult.Failure>(compileFor(LejosVersion.V3_0, text))
        assertContains(rejected.diagnostics.single().message, "IllegalStateException")
    }

    @Test
    fun `every gap is refused where it is used, and its hint says what to write`() = runTest {
        for ((use, hint) in USES) assertContains(diagnostics(use).first().message, hint)
        for ((use, hint) in USES_OF_30) {
            assertIs<CompilationResult.Success>(compileFor(LejosVersion.V3_0, program(use)), use)
            val rejected = assertIs<CompilationResult.Failure>(compileFor(LejosVersion.V2_1, program(use)), use)
            assertContains(rejected.diagnostics.first().message, hint)
        }
    }

    @Test
    fun `every difference is refused for the versions that lack it, and accepted for the others`() = runTest {
        val differences = LejosDifferences.all.filter { it.instead != LejosRemedy.CHECKED_EXCEPTION }
        for (difference in differences) {
            val text = program("try { ${useOf(difference)} } catch (Exception e) { }")
            for (version in LejosVersion.entries) {
                val isRefused = compileFor(version, text) is CompilationResult.Failure
                assertEquals(!difference.isIn(version), isRefused, "${version.label}: $text")
            }
        }
    }

    /** A statement that uses what [difference] is about. */
    private fun useOf(difference: LejosDifference): String {
        val owner = difference.owner.replace('/', '.')
        val name = difference.member.substringBefore('(').substringBefore(':')
        val parameters = difference.member.substringAfter('(', "").substringBefore(')')
        val arguments = PARAMETER.findAll(parameters).joinToString { ARGUMENTS.getValue(it.value) }
        return when {
            name.isEmpty() -> "$owner o = null;"
            name == "<init>" -> "throw new $owner($arguments);"
            '(' in difference.member -> "(($owner) null).$name($arguments);"
            else -> "int value = $owner.$name;"
        }
    }

    @Test
    fun `what takes a change in one place can be fixed at once`() = runTest {
        for ((use, expected) in FIXES) {
            val text = program(use)
            val rejected = assertIs<CompilationResult.Failure>(compileFor(LejosVersion.V3_0, text))
            val fixed = withFix(text, assertNotNull(rejected.diagnostics.first().fix, use))
            assertEquals(program(expected), fixed)
            assertIs<CompilationResult.Success>(compileFor(LejosVersion.V3_0, fixed), fixed)
        }
    }

    @Test
    fun `what takes more than that has a hint only`() = runTest {
        for (use in listOf(
            "int depth = new java.util.Stack().search(null);",
            "Sensor s = Sensor.S2; int mode = s.RAW_VALUE;",
            "Throwable t = new Error(\n\"late\");",
        )) {
            assertNull(diagnostics(use).single().fix, use)
        }
    }

    @Test
    fun `a large step of a variable of a method is refused, and others are accepted`() = runTest {
        val refused =
            listOf("i += 128;", "i -= 129;", "i += 32767;", "i += -129;", "i += 'a' + 31;", "for (; i < 9; i += 200) ;")
        for (step in refused) {
            val diagnostic = diagnostics("int i = 0; $step").single()
            assertContains(diagnostic.message, "127", message = step)
            assertContains(diagnostic.message, "i = i ", message = step)
        }
        val accepted = listOf(
            "i += 127;",
            "i -= 128;",
            "i += -128;",
            "i += 32768;",
            "i += i;",
            "i = i + 200;",
            "i *= 200;",
            "short s = 1; s += 200;",
            "float f = 1; f += 200;",
            "int[] a = {1}; a[0] += 200;",
        )
        for (step in accepted) {
            assertIs<CompilationResult.Success>(compileFor(LejosVersion.V3_0, program("int i = 0; $step")), step)
        }
        val field = "class Robot { int i; void go() { i += 200; this.i -= 200; } }"
        assertIs<CompilationResult.Success>(compileFor(LejosVersion.V3_0, field))
        assertIs<CompilationResult.Success>(compile(program("int i = 0; i += 200;")))
    }

    @Test
    fun `members of the same name that leJOS has are accepted`() = runTest {
        val own =
            "class Robot { static class Pile extends java.util.Stack { public int search(Object o) { return 1; } }\n" +
                "int depth() { return new Pile().search(null) + SensorConstantsHere.TOUCH; }\n" +
                "static class SensorConstantsHere { static final int TOUCH = 1; } }"
        assertIs<CompilationResult.Success>(compileFor(LejosVersion.V3_0, own))
        val constants = "int t = SensorConstants.SENSOR_TYPE_TOUCH; Exception e = new Exception(\"late\");"
        assertIs<CompilationResult.Success>(compileFor(LejosVersion.V3_0, program(constants)))
    }

    @Test
    fun `without a brick to compare with, everything of the library is accepted`() = runTest {
        for ((use, _) in USES) assertIs<CompilationResult.Success>(compile(program(use)), use)
    }

    @Test
    fun `a number behind a text is a warning`() = runTest {
        for (joined in listOf("\"a\" + n", "n + \"a\"", "\"a\" + 1.5f * n", "args[0] + (byte) n")) {
            val warning = compiled(program("int n = args.length; String s = $joined;")).warnings.single()
            assertEquals(joined, warning.text)
            assertContains(warning.message, "LCD.showNumber")
        }
        val others = "String s = \"a\" + args[0] + 'b' + true; String t = \"a\" + 1;"
        assertEquals(emptyList(), compiled(program(others)).warnings)
        val sum = compiled(program("int n = args.length; String s = \"a\"; s += n;")).warnings.single()
        assertNull(sum.fix)
    }

    private companion object {
        val PARAMETER = Regex("L[^;]*;|\\[B|[IF]")
        val ARGUMENTS = mapOf(
            "I" to "7",
            "[B" to "null",
            "F" to "7.5f",
            "Ljava/lang/Object;" to "null",
            "Ljava/lang/String;" to "\"late\"",
        )

        const val BUFFER = "new StringBuffer(20)"

        val USES = listOf(
            "StringBuilder b = null;" to "StringBuffer",
            "Object b = new StringBuilder[3];" to "StringBuffer",
            "char[] c = StringUtils.getCharacters(7);" to "Integer.toString(",
            "char[] c = StringUtils.getCharacters(7.5f);" to BUFFER,
            "int depth = new java.util.Stack().search(null);" to "lastIndexOf",
            "int type = Sensor.SENSOR_TYPE_TOUCH;" to "SensorConstants.SENSOR_TYPE_TOUCH",
            "int mode = Sensor.S1.SENSOR_MODE_BOOL;" to "SensorConstants.SENSOR_MODE_BOOL",
            "Sensor s = Sensor.S2; int mode = s.RAW_VALUE;" to "SensorConstants.RAW_VALUE",
            "try { new java.net.Socket(\"a\", 1).close(); } catch (java.io.IOException e) { }" to "Leave it out",
            "Object o = new NoClassDefFoundError();" to "new NoClassDefFoundError(\"text\")",
            "josx.rcxcomm.LLC.write(new byte[2], 2);" to "LLC.sendBytes",
        )

        /** Uses with a fix, and the same statements fixed. */
        val FIXES = listOf(
            "StringBuilder b = null;" to "StringBuffer b = null;",
            "int type = Sensor.SENSOR_TYPE_TOUCH;" to "int type = SensorConstants.SENSOR_TYPE_TOUCH;",
            "Sensor.S1.setTypeAndMode(Sensor.SENSOR_TYPE_LIGHT, 0);" to
                "Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_LIGHT, 0);",
            "Object o = new IllegalStateException(\"a\" + (1 + 2));" to "Object o = new IllegalStateException();",
            "char[] c = StringUtils.getCharacters(7);" to "char[] c = Integer.toString(7).toCharArray();",
            "char[] c = StringUtils.getCharacters(2 * 7.5f);" to
                "char[] c = new StringBuffer(20).append(2 * 7.5f).getChars();",
            "Object o = new NoClassDefFoundError();" to "Object o = new NoClassDefFoundError(\"\");",
            "josx.rcxcomm.LLC.write(new byte[2], 2);" to "josx.rcxcomm.LLC.sendBytes(new byte[2], 2);",
            "int i = 0; i += 128;" to "int i = 0; i = i + 128;",
            "int i = 0; i -= 500;" to "int i = 0; i = i - 500;",
            "final int step = 64; int i = 0; i += step * 2 ;" to "final int step = 64; int i = 0; i = i + (step * 2) ;",
        )

        /** What came with leJOS 3.0. */
        val USES_OF_30 = listOf(
            "Message.send((byte) 3);" to "Serial.sendPacket",
            "Object o = new java.util.Stack();" to "a Vector",
            "java.util.Queue q = null;" to "a Vector",
            "int last = new java.util.Vector().lastIndexOf(null);" to "from the last one",
            "int last = new java.util.Vector().lastIndexOf(null, 2);" to "from the last one",
            "josx.rcxcomm.remotecontrol.RemoteControlAdapter r = null;" to "josx.platform.rcx.remotecontrol",
        )
    }
}
