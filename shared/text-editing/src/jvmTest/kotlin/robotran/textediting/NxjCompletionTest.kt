package robotran.textediting

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.javacompiler.edit.BrickApi
import robotran.language.ProgramLanguage
import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.CodeTokens
import robotran.languagesupport.Completion
import robotran.languagesupport.CompletionHelp
import robotran.languagesupport.TextLines
import robotran.nxjlibrary.NxjSources
import robotran.programs.support
import robotran.textediting.complete.completionsAt
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import kotlin.test.BeforeTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** Completion and colours in Java for an NXT. */
class NxjCompletionTest {
    @BeforeTest
    fun load() = runBlocking { NxjSources.load() }.let { }

    private fun offered(marked: String, brick: BrickKind = BrickKind.RCX): List<Completion> {
        val draft = TextDocument(marked.replace("|", ""), TextSelection(marked.indexOf('|')))
        val list =
            completionsAt(draft, ProgramLanguage.JAVA.support.code, CompletionHelp { null }, isExplicit = true, brick)
        return list?.items.orEmpty()
    }

    private fun labels(marked: String, brick: BrickKind = BrickKind.RCX) = offered(marked, brick).map { it.label }

    @Test
    fun `members are those of the classes that the imports name`() {
        val ofMotor = labels("import lejos.nxt.*;\nMotor.A.ro|")
        assertEquals(listOf("rotate(int angle)", "rotate(int angle, boolean immediateReturn)"), ofMotor.take(2))
        assertEquals(emptyList(), labels("import josx.platform.rcx.*;\nMotor.A.ro|"))
        val ofPilot = labels("import lejos.robotics.navigation.*;\nDifferentialPilot pilot;\npilot.tra|")
        assertTrue("travel(double distance)" in ofPilot, "$ofPilot")
    }

    @Test
    fun `members that leJOS NXJ lacks are not offered`() {
        val ofList = labels("import java.util.*;\nimport lejos.nxt.*;\nLinkedList list;\nlist.|", BrickKind.NXT)
        assertTrue("add(E element)" in ofList && "remove(int index)" in ofList, "$ofList")
        assertEquals(emptyList(), ofList.filter { it.startsWith("addLast") || it.startsWith("removeFirst") })
    }

    @Test
    fun `without imports the robot's brick decides`() {
        assertTrue("UltrasonicSensor" in labels("Ultra|", BrickKind.NXT))
        assertFalse("UltrasonicSensor" in labels("Ultra|"))
        assertTrue("enum" in labels("enu|", BrickKind.NXT))
        assertFalse("enum" in labels("enu|"))
    }

    @Test
    fun `a class comes with a sentence of help`() {
        val sonar = offered("import lejos.nxt.*;\nUltrasonicS|").first { it.label == "UltrasonicSensor" }
        assertTrue(assertNotNull(sonar.help).startsWith("A sensor that measures by sound"), sonar.help)
    }

    @Test
    fun `classes have their colour where the program has them`() {
        fun kind(text: String) = CodeTokens(
            TextLines("$text\nSensor UltrasonicSensor"),
            ProgramLanguage.JAVA.support.code,
            otherwise = BrickKind.RCX,
        ).of(1)
            .map { it.kind }
        val name = CodeTokenKind.NAME
        val builtIn = CodeTokenKind.BUILT_IN
        assertEquals(listOf(builtIn, name), kind("import josx.platform.rcx.*;"))
        assertEquals(listOf(name, builtIn), kind("import lejos.nxt.*;"))
    }

    @Test
    fun `every class is read from its source`() {
        val api = BrickApi.of(BrickKind.NXT)
        assertTrue(api.classNames.size > 150, "${api.classNames.size} classes")
        for (name in api.classNames) assertNotNull(api.classOf(name), name)
    }
}
