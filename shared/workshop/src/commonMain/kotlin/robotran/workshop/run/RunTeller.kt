package robotran.workshop.run

import robotran.brick.state.RunState
import robotran.narration.RunStory
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.service.Services
import robotran.workshop.state.RunPaneState

/**
 * Tells each run in words when it ends, if the settings say so or the pupil has asked for one in this project.
 *
 * @param now the state of the run.
 * @param story makes the story of the run.
 */
internal class RunTeller(
    private val services: Services,
    private val now: () -> RunPaneState,
    private val story: () -> RunStory,
) {
    private var isAsked = false
    private var wasOver = false

    /** Called after each change of the run. */
    fun look() {
        if (!isAsked && !services.preferences.settings.tellsRuns) return
        val isOver = now().isOver
        if (isOver && !wasOver) publish()
        wasOver = isOver
    }

    /** Tells the run so far. */
    fun tell() {
        isAsked = true
        wasOver = now().isOver
        publish()
    }

    /** Called when another project is opened. */
    fun forget() {
        isAsked = false
        wasOver = false
    }

    private fun publish() = services.publish(RunRoomEvent.Told(story()))
}

/** Whether this is the end of a run. */
private val RunPaneState.isOver: Boolean
    get() {
        if (untouched || isSeeking || inPast) return false
        val hasEnded =
            !running && session.robots.any { it.brick.run is RunState.Ended || it.brick.run is RunState.Failed }
        val isSnippet = brick.isSnippet
        return if (world.goals.isEmpty() || isSnippet) hasEnded else outcome.finished != null && (isPaused || hasEnded)
    }
