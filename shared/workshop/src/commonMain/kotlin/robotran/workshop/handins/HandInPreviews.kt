package robotran.workshop.handins

import robotran.assignments.collecting.Submission
import robotran.documents.validProjectName
import robotran.workshop.service.ProjectSwitcher
import robotran.workshop.service.Services
import robotran.workshop.service.SwitchResult
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInRun
import robotran.workshop.state.Notice

/** Opens hand-ins in the workshop, and the assignment again. */
internal class HandInPreviews(private val switcher: ProjectSwitcher, private val services: Services) {
    /** The ID of the project that was opened from a hand-in. */
    private var visited: String? = null

    /** The ID of the assignment's project; null if it had none. */
    private var left: String? = null

    /** Whether the open project was opened from a hand-in. */
    val isVisiting: Boolean get() = visited != null && visited == switcher.openId

    /** Opens [row] and runs it, see [replayProject]. Returns whether it is open. */
    suspend fun visit(open: OpenAssignment, row: HandInRow, run: HandInRun?): Boolean {
        val submission = row.submission as? Submission.Usable ?: return false
        val task = open.tasks.getOrNull(row.task) ?: return false
        val project = replayProject(task.project, task.plan, submission, run) ?: return false
        val name = validProjectName(row.name) ?: open.name
        val result = switcher.previewProject(name, project) as? SwitchResult.Switched ?: return false
        left = result.previousId
        visited = result.currentId
        services.notices.show(Notice.HandInOpened(row.name, run))
        if (run == null) services.runControls.playInputs() else services.runControls.run()
        return true
    }

    /** Opens the assignment again. Returns whether it is open. */
    suspend fun returnTo(open: OpenAssignment): Boolean {
        if (switcher.returnTo(left, open.name, open.project) !is SwitchResult.Switched) return false
        visited = null
        return true
    }
}
