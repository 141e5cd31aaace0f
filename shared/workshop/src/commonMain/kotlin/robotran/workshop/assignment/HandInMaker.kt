package robotran.workshop.assignment

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import robotran.assignments.doing.HandedInWork
import robotran.assignments.doing.NotAllowed
import robotran.assignments.doing.firstPrograms
import robotran.assignments.doing.handInName
import robotran.assignments.doing.makeHandIn
import robotran.assignments.doing.notAllowedIn
import robotran.documents.fileNameFor
import robotran.documents.projectFile
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.handInLinkOf
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Saving
import robotran.workshop.service.Services
import robotran.workshop.state.AssignmentState
import robotran.workshop.state.HandInStep
import robotran.workshop.state.LinkError

/** The sheet with which a pupil hands in. One piece of work runs at a time. */
internal class HandInMaker(
    private val services: Services,
    private val runs: AssignmentRuns,
    private val memory: AssignmentMemory,
    private val onHandedIn: () -> Unit,
) {
    private val platform = services.platform
    private val preferences = services.preferences
    private val current = services.current

    /** Null while the sheet is closed. */
    var step: HandInStep? by mutableStateOf(null)
        private set

    private var work: Job? = null
    private var asked: HandInStep.Asking? = null
    private var handIn: Project? = null

    fun handle(event: AssignmentEvent.OfHandIn, state: AssignmentState) {
        val now = step
        when (event) {
            AssignmentEvent.HandInRequested -> if (now == null) step = question(state)
            AssignmentEvent.HandInClosed -> leave()
            AssignmentEvent.HandInBackRequested -> goBack(state)
            is AssignmentEvent.NameEntered -> if (now is HandInStep.Asking) step = now.copy(name = event.name)
            is AssignmentEvent.WorkChosen -> if (now is HandInStep.Asking) step = now.choosing(event.isEditor, state)
            is AssignmentEvent.HandInMade -> make(event.withErrors)
            AssignmentEvent.HandInFileSaved -> begin { save() }
            AssignmentEvent.HandInLinkCopied -> begin { copy() }
            AssignmentEvent.HandInLinkShared -> begin { share() }
        }
    }

    /** Who closes the sheet after it has shown the code has handed in. */
    private fun leave() {
        val shown = (step as? HandInStep.Ready)?.takeIf { it.link != null }
        val made = handIn
        close()
        if (shown != null && made != null) remember(made, shown.name)
    }

    /** Ends whatever is under way and closes the sheet. */
    fun close() {
        work?.cancel()
        step = null
        handIn = null
    }

    private fun question(state: AssignmentState): HandInStep.Asking {
        val best = state.tries.best
        val differs = best == null || plain(best.programs) != plain(current.project.firstPrograms)
        return HandInStep.Asking(
            memory.name,
            state.assignment.nameWanted,
            best?.result,
            canChoose = best != null && differs,
            isEditor = best == null,
            notAllowed(state, isEditor = best == null),
            isUnchanged = !state.canBeginAgain,
        )
    }

    private fun HandInStep.Asking.choosing(isEditor: Boolean, state: AssignmentState): HandInStep.Asking =
        copy(isEditor = isEditor, notAllowed = notAllowed(state, isEditor))

    /** What the assignment does not allow in what would be handed in. */
    private fun notAllowed(state: AssignmentState, isEditor: Boolean): List<NotAllowed> {
        val tried = state.tries.best?.programs.takeUnless { isEditor } ?: return state.notAllowed
        return notAllowedIn(state.assignment, tried)
    }

    private fun goBack(state: AssignmentState) {
        work?.cancel()
        val before = asked ?: question(state)
        step =
            question(state).let {
                it.copy(name = before.name).choosing(it.isEditor || (it.canChoose && before.isEditor), state)
            }
    }

    private fun make(withErrors: Boolean) {
        val now = step
        if (now is HandInStep.Asking) asked = now.takeIf { it.canGoOn } ?: return
        val question = asked ?: return
        if (now !is HandInStep.Asking && now !is HandInStep.HasErrors) return
        val best = current.project.tries?.best
        when {
            withErrors -> begin { ready(question.name, HandedInWork(current.project.firstPrograms, shownProgram())) }
            question.isEditor || best == null -> begin { runEditor(question.name) }
            else -> begin { ready(question.name, HandedInWork(best)) }
        }
    }

    private suspend fun runEditor(name: String) {
        step = HandInStep.Running(0f)
        when (val run = runs.runOf(current.project, shownProgram()) { step = HandInStep.Running(it) }) {
            is RunOfWork.Ended -> ready(name, run.work)
            is RunOfWork.HasErrors -> step = HandInStep.HasErrors(run.reasons)
        }
    }

    private suspend fun ready(name: String, work: HandedInWork) {
        val made = makeHandIn(current.project, name, work)
        handIn = made
        val plain = HandInStep.Ready(handInName(name), work.result)
        val address = platform.pageAddress.ifEmpty { preferences.settings.site }
        if (address.isEmpty()) {
            step = plain.copy(linkError = LinkError.NoSite)
            return
        }
        step = when (val link = withContext(platform.background) { handInLinkOf(made, preferences.language) }) {
            is LinkCreation.Made -> plain.copy(link = address + link.fragment)
            is LinkCreation.TooLong -> plain.copy(linkError = LinkError.TooLong(link.message))
        }
    }

    private suspend fun save() {
        val now = step as? HandInStep.Ready ?: return
        val made = handIn ?: return
        val bytes = withContext(platform.background) { projectFile(made) }
        val saving = when (bytes) {
            null -> Saving.Failed("")

            else -> platform.files.save(
                fileNameFor("${made.world.title} - ${now.name}", FileKind.PROJECT),
                FileKind.PROJECT,
                bytes,
            )
        }
        when (saving) {
            is Saving.Saved -> {
                step = now.copy(savedAs = saving.name, saveError = null)
                remember(made, now.name)
            }

            is Saving.Failed -> step = now.copy(saveError = saving.reason)
            Saving.Cancelled -> {}
        }
    }

    private suspend fun copy() {
        val now = step as? HandInStep.Ready ?: return
        val isCopied = platform.sharing.copy(now.link ?: return)
        step = now.copy(isCopied = isCopied)
        if (isCopied) handIn?.let { remember(it, now.name) }
    }

    private suspend fun share() {
        val now = step as? HandInStep.Ready ?: return
        if (platform.sharing.share(now.link ?: return)) handIn?.let { remember(it, now.name) }
    }

    private fun remember(made: Project, name: String) {
        made.assignment?.let { memory.handedIn(it.id, name) }
        onHandedIn()
    }

    private fun begin(what: suspend () -> Unit) {
        work?.cancel()
        work = services.scope.launch { what() }
    }

    private fun shownProgram(): Int {
        val shown = current.shownProgram.name
        return current.project.firstPrograms.indexOfFirst { it.name == shown }.coerceAtLeast(0)
    }

    private fun plain(programs: List<ProjectProgram>) = programs.map { it.copy(view = null) }
}
