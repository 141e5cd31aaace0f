package robotran.workshop.learning

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.launch
import robotran.documents.tutorialWorkName
import robotran.learning.Tutorial
import robotran.learning.TutorialStep
import robotran.programs.SourceFile
import robotran.workshop.programs.pupilPrograms
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProjectEditor
import robotran.workshop.service.ProjectSwitcher
import robotran.workshop.service.ScreenNavigator
import robotran.workshop.service.SwitchResult
import robotran.workshop.state.Pane
import robotran.workshop.state.TutorialState

/**
 * Puts the tutorial's steps on the desk, in a work of its own, and what was there before back again. What a pupil has
 * written in a step is kept and comes back with it.
 *
 * @param keep keeps what has become of the progress.
 */
internal class TutorialController(
    private val scope: CoroutineScope,
    private val preferences: Preferences,
    private val current: CurrentProject,
    private val editor: ProjectEditor,
    private val switcher: ProjectSwitcher,
    private val navigator: ScreenNavigator,
    private val progress: () -> LearningProgress,
    private val keep: (LearningProgress) -> Unit,
) {
    private var isSolutionOnDesk = false

    /** The tutorial as it is shown first: at the step that was shown last. */
    fun first() = TutorialState(Tutorial.steps.indexOfFirst { it.name == progress().step }.coerceAtLeast(0))

    /** The step whose world is on the desk; null if something else is. */
    fun stepOnDesk(): TutorialStep? = Tutorial.stepIn(current.project.world)

    /** The tutorial with [step], which is on the desk. */
    fun show(step: TutorialStep): TutorialState {
        keep(progress().copy(step = step.name, tutorialShown = true))
        val text = programOnDesk(step)
        isSolutionOnDesk = text == step.solution.text && own(step).text != text
        return TutorialState(Tutorial.steps.indexOf(step), solutionShown = isSolutionOnDesk)
    }

    /** Shows the step [place]; if the tutorial is on the desk, that one's program and world come there. */
    fun choose(tutorial: TutorialState, place: Int): TutorialState {
        if (place !in Tutorial.steps.indices) return tutorial
        val chosen = TutorialState(place, isFolded = tutorial.isFolded)
        if (stepOnDesk() != null) {
            keepProgram()
            open(chosen.current, own(chosen.current))
        }
        keep(progress().copy(step = chosen.current.name))
        return chosen
    }

    /** Puts the shown step's program and world on the desk, as the pupil has left them. */
    fun putOnDesk(tutorial: TutorialState): TutorialState {
        bring(tutorial.current, own(tutorial.current))
        navigator.show(Pane.PROGRAM)
        return tutorial.copy(solutionShown = false)
    }

    /** Puts the shown step on the desk as it was given. */
    fun beginAgain(tutorial: TutorialState): TutorialState {
        bring(tutorial.current, tutorial.current.program)
        keep(progress().copy(programs = progress().programs - tutorial.current.name))
        return tutorial.copy(solutionShown = false)
    }

    /** Puts the shown step's solution on the desk, or the pupil's program again. */
    fun showSolution(tutorial: TutorialState, shown: Boolean): TutorialState {
        if (shown == tutorial.solutionShown) return tutorial
        if (shown) keepProgram()
        bring(tutorial.current, if (shown) tutorial.current.solution else own(tutorial.current))
        return tutorial.copy(solutionShown = shown)
    }

    /** Brings back what was on the desk before the tutorial, if that is there now. */
    suspend fun leaveDesk() {
        if (stepOnDesk() == null) return
        keepProgram()
        switcher.resumeProject(progress().ownWork)
    }

    /** Puts [file] and the world of [step] on the desk; what is the pupil's own goes aside first. */
    private fun bring(step: TutorialStep, file: SourceFile) {
        if (stepOnDesk() != null) return open(step, file)
        scope.launch {
            val project = step.project(preferences.language, listOf(file))
            val result = switcher.beginProject(tutorialWorkName(preferences.language), project, progress().tutorialWork)
            if (result is SwitchResult.Switched) {
                isSolutionOnDesk = file === step.solution
                keep(progress().copy(ownWork = result.left, tutorialWork = result.opened))
            }
        }
    }

    private fun open(step: TutorialStep, file: SourceFile) {
        editor.openProject(step.project(preferences.language, listOf(file)))
        isSolutionOnDesk = file === step.solution
    }

    /** Keeps what the pupil has made of the program of the step on the desk, if one is there and not its solution. */
    fun keepProgram() {
        val step = stepOnDesk()
        if (step == null || isSolutionOnDesk) return
        val text = programOnDesk(step) ?: return
        val others = progress().programs - step.name
        keep(progress().copy(programs = if (text == step.program.text) others else others + (step.name to text)))
    }

    private fun programOnDesk(step: TutorialStep): String? =
        current.project.pupilPrograms.firstOrNull { it.name == step.program.name }?.files?.first()?.text

    private fun own(step: TutorialStep) =
        progress().programs[step.name]?.let { SourceFile(step.program.name, it) } ?: step.program
}
