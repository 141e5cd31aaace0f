package robotran.workshop.assignment

import robotran.assignments.doing.firstPrograms
import robotran.language.Language
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.workshop.Workshop
import robotran.workshop.documents.Machine
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.state.AssignmentEditorState
import kotlin.test.assertIs

/** The page on which a teacher makes an assignment of a project. */
abstract class MakingAssignments {
    internal val machine = Machine().apply { files.location = "/home/made.robotran" }

    protected val Workshop.making: AssignmentEditorState get() = checkNotNull(state.making)

    protected fun making(project: Project = AnyAssignment.teachers.copy(assignment = null)): Workshop =
        machine.window(AnyAssignment.request(project)).also { it.handle(AssignmentEvent.MakingRequested) }

    protected fun saved(): Project =
        assertIs<ProjectFileResult.Success>(readProject(machine.files.disk.values.last(), Language.ENGLISH)).project

    protected val Workshop.solutionText: String get() = making.assignment.solution.single().files.single().text

    protected fun textOf(project: Project) = project.firstPrograms.single().files.single().text
}
