package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.rcxrom.log.romCalls
import robotran.robolang.robot.RobotTarget
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.Goal
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.NeverTouch
import robotran.world.Paper
import robotran.world.Penbot
import robotran.world.file.BuiltInWorlds
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import robotran.world.file.writeWorld
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class LanguagesTest {
    private val toldIn = listOf(Language.ENGLISH, Language.SPANISH, Language.GERMAN)
    private val reader =
        ProgramCompiler(
            RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE),
            language = Language.ENGLISH,
        )
    private val world = BuiltInWorlds.plain.copy(
        paper = Paper(200.0, 80.0),
        walls = emptyList(),
        goals = listOf(Goal(InkLength(atLeast = 20.5, atMost = null)), Goal(NeverTouch())),
        timeLimit = 10,
        realism = 1.0,
    )

    private suspend fun errorIn(language: Language, source: ProgramSource): String = assertIs<ProgramResult.Failure>(
        reader.withLanguage(language).compileOrThrow(source),
    ).diagnostics.first().message

    private suspend fun sessionIn(language: Language, text: String): Session {
        val source = Program("a.robo", ProgramLanguage.ROBOLANG, text)
        val program = assertIs<ProgramResult.Success>(reader.withLanguage(language).compileOrThrow(source)).program
        return Session(world, listOf(RobotProgramSet(listOf(program))), loadPhysicsEngine(), language).apply {
            runForGoals()
        }
    }

    @Test
    fun `a reader tells mistakes of both languages in the pupil's own`() = runTest {
        val robolang = Program("a.robo", ProgramLanguage.ROBOLANG, "forward")
        val java = Program(
            "Robot.java",
            ProgramLanguage.JAVA,
            "class Robot { public static void main(String[] args) { spped = 3; } }",
        )
        reader.prepareFor(java)
        assertEquals(
            "Después de \"forward\" va un número, como en \"forward 20\".",
            errorIn(Language.SPANISH, robolang),
        )
        assertEquals(
            "Nach \"forward\" kommt eine Zahl, zum Beispiel \"forward 20\".",
            errorIn(Language.GERMAN, robolang),
        )
        assertEquals(
            listOf(
                "There is no variable \"spped\". Declare it first, such as with \"int spped = 0;\".",
                "No existe la variable \"spped\". Declárala antes, por ejemplo con \"int spped = 0;\".",
                "Es gibt keine Variable \"spped\". Leg sie vorher an, zum Beispiel mit \"int spped = 0;\".",
            ),
            toldIn.map { errorIn(it, java) },
        )
    }

    @Test
    fun `a run is the same in every language and only told in another`() = runTest {
        val sessions = toldIn.map { sessionIn(it, "pen down\nforward 30\nvar zero = 0\nshow 1 / zero") }
        val (english, spanish, german) = sessions
        assertEquals(1, sessions.map { it.traceHash }.toSet().size)
        assertEquals(1, sessions.map { session -> session.state.robots.map { it.robot.pose } }.toSet().size)
        assertEquals(1, sessions.map { session -> session.callLog.entries.romCalls().map { it.call } }.toSet().size)
        assertEquals(listOf("Draw 20.5 cm or more.", "Never touch anything."), english.state.goals.map { it.sentence })
        assertEquals(listOf("Dibuja 20,5 cm o más.", "No toques nunca nada."), spanish.state.goals.map { it.sentence })
        assertEquals(listOf("Zeichne 20,5 cm oder mehr.", "Berühr nie etwas."), german.state.goals.map { it.sentence })
        assertEquals(
            listOf(
                "The program cannot go on. Line 4: 1 cannot be divided by 0. Press On-Off to go back to the start.",
                "El programa no puede seguir. Línea 4: 1 no se puede dividir entre 0. Pulsa On-Off para volver al " +
                    "principio.",
                "Das Programm kann nicht weiter. Zeile 4: 1 kann man nicht durch 0 teilen. Drück auf On-Off, um zum " +
                    "Anfang zurückzukommen.",
            ),
            sessions.map { it.state.brick.explanation },
        )
        assertEquals(toldIn.size, sessions.map { session -> session.explain().map { it.sentence } }.toSet().size)
        assertEquals(1, sessions.map { session -> session.explain().map { it.cause to it.amount } }.toSet().size)
    }

    @Test
    fun `a world that cannot be used says so in the pupil's language`() {
        val file = writeWorld(world).replace("\"width\": 200", "\"width\": \"wide\"")
        assertEquals(
            listOf(
                "Line 5: paper.width must be a number.",
                "Línea 5: paper.width tiene que ser un número.",
                "Zeile 5: paper.width muss eine Zahl sein.",
            ),
            toldIn.map { assertIs<WorldFileResult.Failure>(readWorld(file, it)).message },
        )
    }

    @Test
    fun `a project or a link that cannot be used says so in the pupil's language`() = runTest {
        assertEquals(
            "Esto no es un proyecto de Robotran: un archivo de proyecto dice \"format\": \"robotran-project\".",
            assertIs<ProjectFileResult.Failure>(readProject("{}", Language.SPANISH)).message,
        )
        assertEquals(
            "Das ist kein Link zu einer Welt, einem Projekt oder einem Kurs von Robotran.",
            assertIs<LinkResult.Rejected>(openLink("https://example.org", Language.GERMAN)).message,
        )
    }

    @Test
    fun `a robot that is not there is told in the pupil's language`() = runTest {
        val given = mapOf("anna" to listOf(Program("a.robo", ProgramLanguage.ROBOLANG, "beep")))
        assertEquals(
            listOf(
                "No robot in this world is called anna. There is only one, called yellow.",
                "Ningún robot de este mundo se llama anna. Solo hay uno, que se llama yellow.",
                "Kein Roboter in dieser Welt heißt anna. Es gibt nur einen, der heißt yellow.",
            ),
            toldIn.map {
                assertIs<RobotProgramSets.Failure>(
                    readRobotLoads(world, reader.withLanguage(it), given),
                ).diagnostics.single().message
            },
        )
    }
}
