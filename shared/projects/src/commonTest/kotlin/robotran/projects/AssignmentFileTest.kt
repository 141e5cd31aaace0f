package robotran.projects

import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.world.file.BuiltInWorlds
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class AssignmentFileTest {
    private fun rejected(text: String): ProjectFileResult.Failure = assertIs(readProject(text, Language.ENGLISH), text)

    private val random = Random(2026)

    private fun word() = List(1 + random.nextInt(20)) { LETTERS.random(random) }.joinToString("").ifBlank { "x" }

    private fun <T> some(most: Int, make: () -> T): List<T> = List(random.nextInt(most + 1)) { make() }

    private fun <T> maybe(make: () -> T): T? = if (random.nextBoolean()) make() else null

    private fun assignment() = Assignment(
        id = word(),
        text = some(5) { word() }.joinToString("\n"),
        pictures = some(2) { AssignmentPicture(word(), "iVBORw0KGgo=") },
        mayChangeWorld = random.nextBoolean(),
        languages = ProgramLanguage.entries.filter { random.nextBoolean() },
        words = some(4) { word() },
        hints = some(4) { AssignmentHint(word() + "\n" + word(), maybe { word() }, 1 + random.nextInt(9)) },
        due = maybe { word() }.orEmpty(),
        nameWanted = maybe { word() }.orEmpty(),
        start = FULL_PROJECT.robots.first().programs.filter { random.nextBoolean() },
        checks = maybe {
            val first = random.nextInt(50)
            AssignmentChecks(
                first..first + random.nextInt(AssignmentLimits.MAXIMUM_SEEDS),
                some(2) { WorldVariation(word(), BuiltInWorlds.plain) },
            )
        },
        solution = FULL_PROJECT.robots.first().programs.filter { random.nextBoolean() },
    )

    @Test
    fun `an assignment comes back from its file as it was`() {
        repeat(500) {
            val project = FULL_PROJECT.copy(assignment = assignment())
            assertEquals(project, loaded(writeProject(project)))
        }
    }

    @Test
    fun `tries, a hand-in and feedback come back as they were`() {
        val programs = FULL_PROJECT.robots.first().programs
        val best = BestTry(programs, 1, FULL_PROJECT.inputs, TryResult(1, 2, 12_345, "0123456789abcdef"), 55)
        val project = FULL_PROJECT.copy(
            assignment = Assignment("id", start = programs, solution = programs),
            tries = AssignmentTries(7, best),
            handIn = HandIn("Ann", 7, best.result, "hash"),
            feedback = Feedback("Well done.\nGo on.", listOf(FeedbackResult("", 19, 20), FeedbackResult("far", 3, 20))),
        )
        assertEquals(project, loaded(writeProject(project)))
    }

    @Test
    fun `the examples of the page on assignments can be read and are written as they stand there`() {
        for (text in documentedAssignments.values) {
            val project = loaded(text)
            assertEquals(project, loaded(writeProject(project)))
            assertEquals(text.filterNot { it.isWhitespace() }, writeProject(project).filterNot { it.isWhitespace() })
        }
    }

    @Test
    fun `what is wrong in an assignment is told with its line and place`() {
        val text = documentedAssignments.values.first()
        for ((broken, part) in mapOf(
            text.replace("\"from\": 1", "\"from\": 30") to "assignment.checks.seeds.to",
            text.replace("\"to\": 20", "\"to\": 2000") to "assignment.checks.seeds",
            text.replace("\"afterTries\": 3", "\"afterTries\": 0") to "assignment.hints[1].afterTries",
            text.replace("[\"robolang\"]", "[\"pascal\"]") to "assignment.languages[0]",
            text.replace("iVBORw0KGgo", "not Base64!") to "assignment.pictures[0].data",
            text.replace("\"id\": \"flag-7c1\",", "") to "assignment.id",
        )) {
            assertTrue(broken != text, part)
            val rejection = rejected(broken)
            assertEquals(part, rejection.path)
            assertTrue(rejection.line != null, rejection.message)
        }
    }

    private companion object {
        const val LETTERS = "abc XYZ äñ .,:;!?'\"\\/<>&{}[]"
    }
}
