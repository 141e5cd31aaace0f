package robotran.assignments.doing

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.types.shouldBeInstanceOf
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.checkAll
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.AssignmentTries
import robotran.projects.BestTry
import robotran.projects.LinkCreation
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.TryResult
import robotran.projects.WorldVariation
import robotran.projects.linkOf
import robotran.projects.openLink
import robotran.projects.readProject
import robotran.projects.writeProject
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import kotlin.random.Random

class PupilCopyProperties :
    StringSpec({
        "what pupils get has neither solution nor checks, in a file and in a link" {
            checkAll(PROJECTS) { project ->
                val copy = pupilCopy(project)
                val file = writeProject(copy)
                file shouldNotContain SECRET
                val assignment = checkNotNull(copy.assignment)
                assignment.checks.shouldBeNull()
                assignment.solution.shouldBeEmpty()
                copy.tries.shouldBeNull()
                readProject(file, Language.ENGLISH).shouldBeInstanceOf<ProjectFileResult.Success>().project shouldBe
                    copy
                val link = linkOf(copy, Language.ENGLISH).shouldBeInstanceOf<LinkCreation.Made>().fragment
                val opened = openLink(link, Language.ENGLISH).shouldBeInstanceOf<LinkResult.OfProject>().project
                opened shouldBe copy
                writeProject(opened) shouldNotContain SECRET
            }
        }

        "what the author keeps has all of it, and makes the same copy for pupils" {
            checkAll(PROJECTS) { project ->
                val copy = teacherCopy(project)
                val assignment = checkNotNull(copy.assignment)
                assignment.checks shouldBe project.assignment?.checks
                assignment.solution shouldBe project.assignment?.solution
                pupilCopy(copy) shouldBe pupilCopy(project)
            }
        }
    })

/** In every text that pupils must not get. */
private const val SECRET = "SECRET"

/** Authors' projects, with the solution among the open programs, among those to begin with, in both or in neither. */
private val PROJECTS: Arb<Project> = arbitrary { project(it.random) }

private fun project(random: Random): Project {
    val world = BuiltInWorlds.plain
    val solution = List(random.nextInt(1, 3)) { program("solution$it.robo", "forward $it // $SECRET\n") }
    val plain = List(random.nextInt(3)) { program("begin$it.robo", "beep // $it\n") }
    val java =
        List(random.nextInt(2)) { program("Solution$it.java", "class Solution$it {} // $SECRET", ProgramLanguage.JAVA) }
    val all = solution + java
    val some = { (plain + all).shuffled(random).take(random.nextInt(MAX_PROGRAMS)) }
    val assignment = Assignment(
        id = "id",
        text = "Drive.\n".repeat(random.nextInt(4)),
        start = some(),
        checks = AssignmentChecks(
            1..random.nextInt(1, 9),
            List(random.nextInt(3)) {
                WorldVariation("$SECRET $it", hidden(world))
            },
        ),
        solution = all,
    )
    val best = BestTry(all, 0, emptyList(), TryResult(0, 0, 1, SECRET))
    val robot = ProjectRobot(world.robots.first().name, some())
    return Project(
        world,
        listOf(robot).filter { it.programs.isNotEmpty() },
        assignment = assignment,
        tries = AssignmentTries(1, best),
    )
}

private fun hidden(world: World) = world.copy(title = "$SECRET world")

private fun program(name: String, text: String, language: ProgramLanguage = ProgramLanguage.ROBOLANG) =
    ProjectProgram(Program(name, language, text))

/** Of a brick. */
private const val MAX_PROGRAMS = 5
