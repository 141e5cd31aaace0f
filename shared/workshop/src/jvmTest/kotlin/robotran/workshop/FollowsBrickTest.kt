package robotran.workshop

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.brick.state.RunState
import robotran.language.ProgramLanguage
import robotran.languagesupport.CompletionHelp
import robotran.programs.Program
import robotran.programs.support
import robotran.textediting.complete.completionsAt
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.examples.examplesFor
import robotran.world.ReadyRobots
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** What a pupil opens or writes fits the brick of the robot, or the pupil is told. */
class FollowsBrickTest {
    private val workshop = runBlocking { openWorkshop() }

    @AfterTest
    fun close() = workshop.close()

    private fun compile() = runBlocking { workshop.compilePrograms() }

    private fun use(brick: BrickKind) {
        workshop.handle(WorldEditEvent.PenbotChosen(workshop.state.programs.shownRobot, brick))
        compile()
    }

    private fun begin(brick: BrickKind) = workshop.handle(DocumentEvent.NewWithBrick(brick))

    private fun openExample(language: ProgramLanguage, name: String, brick: BrickKind) {
        workshop.handle(LearningEvent.ExampleChosen(language, name, brick))
        compile()
        assertEquals(name, workshop.state.programName)
    }

    /** Whether the shown program has no mistakes and runs without lacking a sensor. */
    private fun isFit(): Boolean {
        if (workshop.state.diagnostics.isNotEmpty()) return false
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1_000)
        val isFailed = workshop.state.session.brick.run is RunState.Failed
        return workshop.state.shownProgramRun.missingSensors == null && !isFailed
    }

    @Test
    fun `every example is fit for the robot that is open, or the bar names the other brick`() {
        val described = mutableMapOf<BrickKind, MutableMap<String, BrickKind>>()
        for (robot in BrickKind.entries) {
            for ((language, brick) in SETS) {
                for (name in language.examplesFor(brick).keys) {
                    begin(robot)
                    openExample(language, name, brick)
                    val other = workshop.state.programs.otherBrick
                    assertTrue((other == null) == isFit(), "$name for an $brick on an $robot: $other")
                    if (other == null) continue
                    if (language == ProgramLanguage.ROBOLANG) {
                        described.getOrPut(robot, ::mutableMapOf)[name] = other
                    } else {
                        assertEquals(brick, other, name)
                    }
                    use(other)
                    assertTrue(isFit(), "$name for an $brick after the change from an $robot")
                }
            }
        }
        val ofRcx = listOf("light-meter.robo", "light-seeker.robo").associateWith { BrickKind.RCX }
        // A hub with one button has none that programs can ask about.
        val ofButtons = listOf("counter.robo", "reaction-game.robo", "stopwatch.robo").associateWith { BrickKind.NXT }
        for (robot in BrickKind.entries) {
            val isWithoutButtons = robot == BrickKind.SPIKE_ESSENTIAL || robot == BrickKind.TECHNIC_HUB
            val expected = when {
                robot == BrickKind.RCX -> emptyMap()
                isWithoutButtons -> ofRcx + ofButtons
                else -> ofRcx
            }
            assertEquals(expected, described[robot].orEmpty(), robot.label)
        }
    }

    @Test
    fun `the examples in Robolang name the ports and buttons of the robot`() {
        for (brick in BrickKind.entries) {
            begin(brick)
            openExample(ProgramLanguage.ROBOLANG, "line-follower.robo", BrickKind.RCX)
            val follower = workshop.state.programText
            when (brick) {
                BrickKind.RCX -> assertContains(follower, "sensor on 2")
                BrickKind.NXT -> assertContains(follower, "sensor on 3")
                else -> assertTrue(
                    "sensor on" !in follower && "motor ${ReadyRobots.defaultOf(brick).drive.right}" in follower,
                )
            }
            openExample(ProgramLanguage.ROBOLANG, "counter.robo", BrickKind.RCX)
            val text = workshop.state.programText
            assertContains(text, if (brick == BrickKind.RCX) "press View" else "press RIGHT")
            assertEquals(brick == BrickKind.RCX, "view" in text.lowercase())
        }
    }

    @Test
    fun `Java that names no brick is compiled for that of the robot`() {
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("Words.java", NAMES_NONE)))
        compile()
        assertTrue(workshop.state.diagnostics.isNotEmpty())
        assertNull(workshop.state.programs.otherBrick)
        use(BrickKind.NXT)
        assertEquals(emptyList(), workshop.state.diagnostics)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(4_000)
        assertTrue(workshop.state.session.brick.screen.text.contains("turn 2"), workshop.state.status.toString())
        use(BrickKind.RCX)
        assertTrue(workshop.state.diagnostics.isNotEmpty())
        workshop.handle(ProgramEvent.ProgramEdited("class Words {\n  public static void main(String[] a) {}\n}\n"))
        compile()
        assertEquals(emptyList(), workshop.state.diagnostics)
        use(BrickKind.NXT)
        assertEquals(emptyList(), workshop.state.diagnostics)
    }

    @Test
    fun `help on Java that names no brick is that for the robot`() {
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("Turn.java", TURN)))
        compile()
        workshop.handle(LearningEvent.HelpRequested(TURN, TURN.indexOf("rotateTo") + 1))
        assertEquals(BrickKind.RCX, workshop.state.learning.help.brick)
        assertNull(workshop.state.learning.help.found)
        use(BrickKind.NXT)
        workshop.handle(LearningEvent.HelpRequested(TURN, TURN.indexOf("rotateTo") + 1))
        assertEquals("Motor.rotateTo", assertNotNull(workshop.state.learning.help.found).word)
    }

    @Test
    fun `completion in Java that names no brick offers what the robot's has`() {
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("Turn.java", TURN)))
        use(BrickKind.NXT)
        assertTrue("rotateTo" in offered(BrickKind.NXT))
        assertFalse("rotateTo" in offered(BrickKind.RCX))
    }

    private fun offered(brick: BrickKind): List<String> {
        val caret = TURN.indexOf("rotateTo") + "rotate".length
        val draft = TextDocument(TURN.replace("rotateTo", "rotate"), TextSelection(caret))
        return completionsAt(
            draft,
            ProgramLanguage.JAVA.support.code,
            CompletionHelp {
                null
            },
            isExplicit = true,
            brick,
        )
            ?.items.orEmpty().map { it.inserted.substringBefore('(') }
    }

    private companion object {
        val SETS = listOf(
            ProgramLanguage.ROBOLANG to BrickKind.RCX,
            ProgramLanguage.JAVA to BrickKind.RCX,
            ProgramLanguage.JAVA to BrickKind.NXT,
        )

        /** Texts that are joined are for an NXT alone. */
        const val NAMES_NONE =
            "import java.util.ArrayList;\n" +
                "class Words {\n  public static void main(String[] a) throws InterruptedException {\n" +
                "    ArrayList<String> all = new ArrayList<String>();\n    all.add(\"turn \" + 2);\n" +
                "    System.out.println(all.get(0));\n    Thread.sleep(9000);\n  }\n}\n"
        const val TURN = "class Turn {\n  public static void main(String[] a) {\n    Motor.A.rotateTo(90);\n  }\n}\n"
    }
}
