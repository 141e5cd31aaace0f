package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.narration.RunStory
import robotran.simulation.state.SessionState
import robotran.world.geometry.Point

/** What is told in words above the sheet. */
@Immutable
sealed interface SheetWords {
    /** Where the robot with the index [robot] was when that was asked for, in the state [session]. */
    class WhereIs(val robot: Int, val session: SessionState) : SheetWords

    /** What happened in a run. */
    class Told(val story: RunStory) : SheetWords

    /** What is at [place] of the sheet, where the pupil's cross is. */
    data class Explored(val place: Point) : SheetWords
}
