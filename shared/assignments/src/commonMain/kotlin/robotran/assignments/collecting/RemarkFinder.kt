package robotran.assignments.collecting

import robotran.assignments.doing.forbiddenLanguages
import robotran.assignments.doing.forbiddenWords
import robotran.assignments.doing.isIntact
import robotran.assignments.tokens.KnownSolution
import robotran.json.writeCompactJson
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.world.World
import robotran.world.file.elementOf

/** Finds what a teacher should know about hand-ins for [assignment]. */
internal class RemarkFinder(private val assignment: Project, private val given: GivenWork) {
    private val world by lazy { compact(assignment.world) }
    private val solution = KnownSolution(assignment)

    /** About a whole project. One that does not belong to any assignment has nothing to compare. */
    fun of(project: Project): List<SubmissionRemark> {
        val own = project.assignment
        val isOfThis = own != null && own.id == assignment.assignment?.id
        val isTeachers = isOfThis && (own.checks != null || own.solution.isNotEmpty())
        return listOfNotNull(
            SubmissionRemark.Changed.takeIf { project.handIn != null && !isIntact(project) },
            SubmissionRemark.TeachersFile.takeIf { isTeachers },
            aboutWorld(project),
        )
    }

    /** The title of the other assignment that [project] was made for; null if it is for this one, or for none. */
    fun otherAssignment(project: Project): String? {
        val id = assignment.assignment?.id ?: return null
        return project.world.title.takeIf { project.assignment != null && project.assignment?.id != id }
    }

    /** About the programs of a hand-in. */
    fun of(programs: List<ProjectProgram>): List<SubmissionRemark> {
        val rules = assignment.assignment ?: return emptyList()
        val languages = forbiddenLanguages(rules, programs)
        val words = forbiddenWords(rules, programs)
        return listOfNotNull(
            SubmissionRemark.Unchanged.takeIf { given.isUnchanged(programs) },
            SubmissionRemark.IsSolution.takeIf { solution.isIn(programs) },
        ) + programs.filter { it.language in languages }.map { SubmissionRemark.LanguageNotAllowed(it.name) } +
            listOfNotNull(words.takeIf { it.isNotEmpty() }?.let(SubmissionRemark::WordsNotAllowed))
    }

    /** Which program of [robot] counts, if there are several. */
    fun chosenOf(robot: ProjectRobot): SubmissionRemark? {
        val names = robot.programs.map { it.name }
        return names.getOrNull(robot.firstProgram)?.takeIf { names.size > 1 }
            ?.let { SubmissionRemark.ChosenInApp(it, names) }
    }

    private fun aboutWorld(project: Project): SubmissionRemark? {
        val rules = assignment.assignment?.takeIf { it.id == project.assignment?.id } ?: return null
        return when {
            compact(project.world) == world -> null
            rules.mayChangeWorld -> SubmissionRemark.OwnWorld
            else -> SubmissionRemark.WorldChanged
        }
    }

    /** As saved, without what does not change a run or is a choice of the pupil. */
    private fun compact(world: World): String {
        val goals = world.goals.map { goal -> goal.withSays { null } }
        return writeCompactJson(elementOf(world.copy(title = "", task = "", goals = goals, seed = 0, realism = 0.0)))
    }
}
