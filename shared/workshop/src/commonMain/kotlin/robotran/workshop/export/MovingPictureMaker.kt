package robotran.workshop.export

import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.channelFlow
import kotlinx.coroutines.flow.flow
import kotlinx.coroutines.flow.flowOn
import robotran.animatedpicture.AnimationStep
import robotran.animatedpicture.animatedGif
import robotran.runcontrol.RecordedRun
import robotran.simulation.state.SessionState
import robotran.workshop.platform.Platform
import robotran.workshop.state.MovingKind
import robotran.workshop.state.ShowSpeed

/** What a [MovingPictureMaker] reports. */
internal sealed interface MakingStep {
    /** [part] of the work is done, 0..1. */
    data class Progress(val part: Float) : MakingStep

    /** @property states what is seen in the picture, frame by frame. */
    class Done(val bytes: ByteArray, val states: List<SessionState>) : MakingStep

    data object TooLarge : MakingStep

    /** The recorder failed. */
    data object NoVideo : MakingStep
}

/** Repeats a run and makes a moving picture of it, in slices, so that the screen stays alive in a browser, too. */
internal class MovingPictureMaker(private val platform: Platform) {
    /** The work, which begins when it is collected; cancelling the collector ends it. The last element is the result. */
    fun make(run: RecordedRun, kind: MovingKind, speed: ShowSpeed): Flow<MakingStep> = when (kind) {
        MovingKind.PICTURE -> picture(run, speed).flowOn(platform.background)

        // The browser's recorder works where the screen is drawn.
        MovingKind.VIDEO -> video(run, speed)
    }

    private fun picture(run: RecordedRun, speed: ShowSpeed): Flow<MakingStep> = flow {
        val states = repeated(run, speed) { emit(MakingStep.Progress(it * REPEATING)) }
        val source = RunFrames(states, platform.pictures.frames(run.world, MOVING_SIDE))
        var slice = 0
        for (step in animatedGif(source)) {
            when (step) {
                is AnimationStep.Progress -> {
                    emit(MakingStep.Progress(REPEATING + step.done * (1 - REPEATING) / step.total))
                }

                is AnimationStep.Finished -> emit(MakingStep.Done(step.bytes, states))
                AnimationStep.TooLarge -> emit(MakingStep.TooLarge)
            }
            if (++slice % FRAMES_PER_SLICE == 0) delay(1)
        }
    }

    private fun video(run: RecordedRun, speed: ShowSpeed): Flow<MakingStep> = channelFlow {
        val states = repeated(run, speed) { send(MakingStep.Progress(it * REPEATING)) }
        val source = RunFrames(states, platform.pictures.frames(run.world, MOVING_SIDE))
        val bytes = platform.videos.record(source) { shown ->
            trySend(MakingStep.Progress(REPEATING + shown * (1 - REPEATING) / states.size))
        }
        send(if (bytes == null) MakingStep.NoVideo else MakingStep.Done(bytes, states))
    }

    private suspend fun repeated(
        run: RecordedRun,
        speed: ShowSpeed,
        report: suspend (Float) -> Unit,
    ): List<SessionState> {
        val count = run.frameCount(speed)
        val states = ArrayList<SessionState>(count)
        for (state in run.statesAt(speed)) {
            states += state
            if (states.size % STATES_PER_SLICE == 0) {
                report(states.size.toFloat() / count)
                delay(1)
            }
        }
        return states
    }

    private companion object {
        /** The part of the work that repeating the run is, measured for a minute at double speed. */
        const val REPEATING = 0.2f
        const val STATES_PER_SLICE = 5
        const val FRAMES_PER_SLICE = 2
    }
}
