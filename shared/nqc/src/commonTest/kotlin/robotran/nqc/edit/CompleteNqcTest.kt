package robotran.nqc.edit

import robotran.language.Language
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.Vectors
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNull
import kotlin.test.assertTrue

class CompleteNqcTest {
    @Test
    fun `outside of tasks begin units`() {
        val labels = labelsAt("int x;\n|")
        assertTrue(labels.containsAll(listOf("task main() { }", "sub { }", "int", "#define")), labels.toString())
        assertFalse("OnFwd(outputs)" in labels)
    }

    @Test
    fun `statements are calls and words`() {
        val labels = labelsAt("int x; sub s() { } task main() { O| }")
        assertTrue(labels.containsAll(listOf("OnFwd(outputs)", "s()", "x", "until(condition)", "while () { }")))
        assertFalse("SENSOR_1" in labels)
    }

    @Test
    fun `what most programs need comes first`() {
        val labels = labelsAt("task main() { S| }").filter { it.startsWith("S") }
        assertEquals(listOf("SetSensor(sensor, kind)", "SetPower(outputs, power)"), labels.take(2))
        assertEquals("OnFwd(outputs)", labelsAt("task main() { | }").first())
    }

    @Test
    fun `arguments come first`() {
        assertEquals("OUT_A", labelsAt("task main() { OnFwd(| }").first())
        assertEquals("SENSOR_1", labelsAt("task main() { SetSensor(| }").first())
        assertEquals("SENSOR_TOUCH", labelsAt("task main() { SetSensor(SENSOR_1, | }").first())
        assertEquals("SOUND_CLICK", labelsAt("task main() { if (true) PlaySound(S|").first())
    }

    @Test
    fun `values and variables are in expressions`() {
        val labels = labelsAt("#define MAX 3\nint count; task main() { int near; near = | }")
        assertTrue(
            labels.containsAll(listOf("count", "near", "MAX", "SENSOR_1", "Timer(n)", "true")),
            labels.toString(),
        )
        assertFalse("OnFwd(outputs)" in labels)
    }

    @Test
    fun `tasks can be started`() {
        assertEquals(listOf("blink", "main"), labelsAt("task blink() { } task main() { start |; }"))
    }

    @Test
    fun `the word that is written is no candidate`() {
        assertFalse("coun" in labelsAt("task main() { int coun| }"))
        assertEquals("cou", completeNqc("task main() { cou", 17, Language.ENGLISH)?.typed)
    }

    @Test
    fun `directives complete`() {
        assertTrue("#include" in labelsAt("#in|"))
        assertEquals(0, completeNqc("#in", 3, Language.ENGLISH)?.start)
    }

    @Test
    fun `nothing completes in comments and texts and numbers`() {
        assertNull(completeAt("// On|"))
        assertNull(completeAt("/* On\n On|"))
        assertNull(completeAt("#include \"a|"))
        assertNull(completeAt("task main() { Wait(12|"))
    }

    @Test
    fun `the firmware decides what there is`() {
        val source = "task main() { "
        val first = completeNqc(source, source.length, Language.GERMAN, FirmwareTarget.RCX)
        val second = completeNqc(source, source.length, Language.GERMAN)
        assertFalse(checkNotNull(first).items.any { it.label.startsWith("SetEvent") })
        val event = checkNotNull(second).items.first { it.label.startsWith("SetEvent") }
        assertTrue(checkNotNull(event.help).startsWith("Legt Ereignis"))
    }

    @Test
    fun `the caret goes into the brackets`() {
        val item = checkNotNull(completeAt("task main() { On|")).items.first { it.label == "OnFwd(outputs)" }
        assertEquals("OnFwd();" to 6, item.inserted to item.caret)
    }

    @Test
    fun `no place of a program is a problem`() {
        for (source in Vectors.programs.values) {
            for (caret in 0..source.length step 7) completeNqc(source, caret, Language.SPANISH)
        }
        assertNull(completeNqc("", 5, Language.ENGLISH))
    }

    private fun completeAt(marked: String) = completeNqc(marked.replace("|", ""), marked.indexOf('|'), Language.ENGLISH)

    private fun labelsAt(marked: String) = checkNotNull(completeAt(marked)).items.map { it.label }
}
