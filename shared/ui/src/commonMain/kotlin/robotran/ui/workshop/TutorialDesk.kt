package robotran.ui.workshop

import robotran.language.Language
import robotran.learning.Tutorial
import robotran.learning.TutorialStep
import robotran.programs.SourceFile
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.projects.writeProject
import robotran.world.BuiltInWorlds

/**
 * Puts the tutorial's steps on the desk, each as a project of its own, and what was there before back again. What a pupil has written in a step is
 * kept and comes back with it.
 *
 * @param keep keeps what has become of the progress.
 */
internal class TutorialDesk(
    private val bench: Bench,
    private val language: () -> Language,
    private val progress: () -> LearningProgress,
    private val keep: (LearningProgress) -> Unit,
) {
    /** The tutorial as it is shown first: at the step that was shown last. */
    fun first() = TutorialState(Tutorial.steps.indexOfFirst { it.name == progress().step }.coerceAtLeast(0))

    /** The step whose world is on the desk; null if something else is. */
    fun stepOnDesk(): TutorialStep? = Tutorial.stepIn(bench.project.world)

    /** Shows the step [place]; if the tutorial is on the desk, that one's program and world come there. */
    fun choose(tutorial: TutorialState, place: Int): TutorialState {
        if (place !in Tutorial.steps.indices) return tutorial
        val chosen = TutorialState(place, isFolded = tutorial.isFolded)
        keep(progress().copy(step = chosen.current.name))
        return if (stepOnDesk() == null) chosen else putOnDesk(chosen, keepsSolution = tutorial.solutionShown)
    }

    /** Puts the shown step's program and world on the desk, as the pupil has left them. */
    fun putOnDesk(tutorial: TutorialState): TutorialState = putOnDesk(tutorial, keepsSolution = false)

    /** Puts the shown step on the desk as it was given. */
    fun beginAgain(tutorial: TutorialState): TutorialState {
        keep(progress().copy(programs = progress().programs - tutorial.current.name))
        open(tutorial.current, tutorial.current.program)
        return tutorial.copy(solutionShown = false)
    }

    /** Puts the shown step's solution on the desk, or the pupil's program again. */
    fun showSolution(tutorial: TutorialState, shown: Boolean): TutorialState {
        if (shown == tutorial.solutionShown) return tutorial
        if (shown) leaveOrKeep(solutionShown = false)
        open(tutorial.current, if (shown) tutorial.current.solution else own(tutorial.current))
        return tutorial.copy(solutionShown = shown)
    }

    /** Brings back what was on the desk before the tutorial, if that is there now. */
    fun leaveDesk() {
        if (stepOnDesk() == null) return
        keepProgram()
        val before = progress().ownWork?.let { readProject(it) as? ProjectFileResult.Loaded }?.project
        keep(progress().copy(ownWork = null))
        bench.openProject(before ?: Project(BuiltInWorlds.plain))
    }

    private fun putOnDesk(tutorial: TutorialState, keepsSolution: Boolean): TutorialState {
        leaveOrKeep(keepsSolution)
        open(tutorial.current, own(tutorial.current))
        bench.show(Pane.PROGRAM)
        return tutorial.copy(solutionShown = false)
    }

    private fun leaveOrKeep(solutionShown: Boolean) {
        when {
            stepOnDesk() == null -> keep(progress().copy(ownWork = writeProject(bench.project)))
            !solutionShown -> keepProgram()
        }
    }

    /** Keeps what the pupil has made of the program of the step on the desk. */
    private fun keepProgram() {
        val step = stepOnDesk() ?: return
        val program = pupilProgramsOf(bench.project).firstOrNull { it.name == step.program.name } ?: return
        val text = program.files.first().text
        val kept = if (text == step.program.text || text == step.solution.text) progress().programs - step.name else progress().programs + (step.name to text)
        keep(progress().copy(programs = kept))
    }

    private fun own(step: TutorialStep) = progress().programs[step.name]?.let { SourceFile(step.program.name, it) } ?: step.program

    private fun open(step: TutorialStep, file: SourceFile) = bench.openProject(step.project(language(), listOf(file)))
}
