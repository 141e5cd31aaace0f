package robotran.workshop.event

import robotran.workshop.platform.FileKind
import robotran.workshop.state.MovingKind
import robotran.workshop.state.ShowSpeed

/** A user action while showing what was made. */
sealed interface ExportEvent : SchoolEvent {
    /** Opens the choice of what to make. */
    data object Requested : ExportEvent

    /** Chooses a moving picture of the run. */
    data class MovingChosen(val kind: MovingKind) : ExportEvent

    data class SpeedChosen(val speed: ShowSpeed) : ExportEvent

    /** Makes the moving picture that was chosen. */
    data object MakingRequested : ExportEvent

    /** Saves the sheet as a picture of [kind], PNG or SVG. */
    data class StillChosen(val kind: FileKind) : ExportEvent

    data object PosterChosen : ExportEvent

    /** Changes what is on the poster. */
    data class PosterChanged(val title: String, val maker: String, val isDated: Boolean) : ExportEvent

    data object PosterPrinted : ExportEvent

    data object PosterSaved : ExportEvent

    /** Cancels what is under way, and returns to the choice. */
    data object BackRequested : ExportEvent

    /** Cancels what is under way, and closes. */
    data object Closed : ExportEvent
}
