package robotran.assignments.collecting

import robotran.assignments.doing.forbiddenLanguages
import robotran.assignments.doing.forbiddenWords
import robotran.assignments.doing.isIntact
import robotran.json.writeCompactJson
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.world.World
import robotran.world.file.elementOf

/** Finds what a teacher should know about hand-ins for [assignment]. */
internal class RemarkFinder(private val assignment: Project, private val given: GivenWork) {
    private val world by lazy { compact(assignment.world) }

    /** About a whole project. One that does not belong to any assignment has nothing to compare. */
    fun of(project: Project): List<SubmissionRemark> {
        val changed = SubmissionRemark.Changed.takeIf { project.handIn != null && !isIntact(project) }
        return listOfNotNull(changed, aboutAssignment(project))
    }

    /** About the programs of a hand-in. */
    fun of(programs: List<ProjectProgram>): List<SubmissionRemark> {
        val rules = assignment.assignment ?: return emptyList()
        val languages = forbiddenLanguages(rules, programs)
        val words = forbiddenWords(rules, programs)
        return listOfNotNull(SubmissionRemark.Unchanged.takeIf { given.isUnchanged(programs) }) +
            programs.filter { it.language in languages }.map { SubmissionRemark.LanguageNotAllowed(it.name) } +
            listOfNotNull(words.takeIf { it.isNotEmpty() }?.let(SubmissionRemark::WordsNotAllowed))
    }

    private fun aboutAssignment(project: Project): SubmissionRemark? {
        val rules = assignment.assignment ?: return null
        val own = project.assignment ?: return null
        return when {
            own.id != rules.id -> SubmissionRemark.OtherAssignment(project.world.title)
            compact(project.world) == world -> null
            rules.mayChangeWorld -> SubmissionRemark.OwnWorld
            else -> SubmissionRemark.WorldChanged
        }
    }

    /** As saved, without what does not change a run or is a choice of the pupil. */
    private fun compact(world: World): String =
        writeCompactJson(elementOf(world.copy(title = "", task = "", seed = 0, realism = 0.0)))
}
