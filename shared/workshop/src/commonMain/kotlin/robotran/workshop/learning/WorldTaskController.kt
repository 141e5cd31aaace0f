package robotran.workshop.learning

import robotran.learning.GalleryWorld
import robotran.learning.Lesson
import robotran.learning.WorldGallery
import robotran.programs.Program
import robotran.simulation.state.SessionState
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Preferences
import robotran.workshop.service.RunControls
import robotran.workshop.service.pupilPrograms
import robotran.workshop.state.TaskHelp
import robotran.workshop.state.WorldTaskState
import robotran.world.World

/**
 * Helps with the task of the gallery's world that is loaded. The pupil's programs stay where they are; what comes with
 * the task goes into tabs of its own.
 */
internal class WorldTaskController(
    private val preferences: Preferences,
    private val current: CurrentProject,
    private val newTabs: NewTabs,
    private val runControls: RunControls,
    private val hints: HintGiver,
) {
    private val nqc = NqcVersions()

    private val isInNqc: Boolean get() = nqc.isIn(current.shownProgram)

    private var seenWorld: World? = null
    private var seen: GalleryWorld? = null

    /** The name of the program that was shown before the solution. */
    private var nameBefore: String? = null

    /** The world of the gallery, or the variation, that is loaded; null for any other world. */
    fun loadedWorld(): GalleryWorld? {
        val world = current.project.world
        if (world !== seenWorld) {
            seenWorld = world
            seen = WorldGallery.find(world)
        }
        // A teacher's assignment has hints of its own, and its solution stays with the teacher.
        return seen.takeIf { current.project.assignment == null }
    }

    /** The state of the task after any change; [before] was the state before it. */
    fun update(before: WorldTaskState?): WorldTaskState? {
        val world = loadedWorld()
        val task = world?.lesson ?: return null
        val help = before?.takeIf { it.world === world }?.help ?: TaskHelp()
        return WorldTaskState(
            world,
            task,
            help.copy(solutionShown = isSolution(current.shownProgram, task)),
            current.project.pupilPrograms.none { it.name == startOf(task).name },
        )
    }

    /** The program to begin with, in NQC for who writes that. */
    private fun startOf(task: Lesson): Program = beginningOf(task, isInNqc).inWords(preferences.words)

    /**
     * Shows the pupil's version of the program to begin with, or adds the original, in NQC for who writes that. False if
     * there is no room.
     */
    fun putProgram(state: WorldTaskState): Boolean {
        val program = startOf(state.task)
        return newTabs.choose { it.name == program.name } || newTabs.addGiven(program)
    }

    /** The [state] with one more hint if [shown], otherwise with none. */
    fun nextHint(state: WorldTaskState, shown: Boolean): WorldTaskState =
        state.copy(help = hints.next(state.task, state.help, shown))

    /** The [state] after the run of [program] that ended in [session] and failed. */
    fun afterTry(state: WorldTaskState, program: Program, session: SessionState): WorldTaskState {
        if (state.help.solutionShown) return state
        // Programs in two languages have no lines in common.
        val isComparable = program.language == state.task.programLanguage && program.files.size == 1
        val attempt = if (isComparable) state.task.attempt(program.files.first().text, session) else null
        return state.copy(help = hints.after(attempt, state.task, state.help))
    }

    /** The [state] without hints. */
    fun withoutHints(state: WorldTaskState): WorldTaskState = state.copy(help = hints.none(state.help))

    /** Adds the solution, in the language of the shown program if there is one, and runs it; or removes it. */
    fun showSolution(state: WorldTaskState, shown: Boolean) {
        val solutions = solutionsToShow(state.task)
        if (shown) {
            val solution = solutions.firstOrNull { it.language == current.shownProgram.language } ?: solutions.first()
            if (!state.help.solutionShown) nameBefore = current.shownProgram.name
            val isShown = { program: Program -> program.name == solution.name && program.inUsualWords() == solution }
            if (newTabs.choose(isShown) || newTabs.addGiven(solution.inWords(preferences.words))) runControls.run()
        } else {
            newTabs.remove { isSolution(it, state.task) }
            newTabs.choose { it.name == nameBefore }
        }
    }

    private fun isSolution(program: Program, task: Lesson): Boolean {
        val ofItsName = solutionsToShow(task).filter { it.name == program.name }
        return ofItsName.isNotEmpty() && program.inUsualWords() in ofItsName
    }

    /** The solutions of [task]; one translated to NQC only for who writes that, or has had it shown. */
    private fun solutionsToShow(task: Lesson): List<Program> {
        val written = solutionsOf(task)
        val hasNqc = current.project.pupilPrograms.any(nqc::isIn)
        return if (hasNqc) (written + listOfNotNull(nqc.solution(task))).distinct() else written
    }
}
