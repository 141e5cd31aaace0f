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

    /** Makes the moving picture or the poster that was chosen. */
    data object MakingRequested : ExportEvent

    /** Makes a picture of the sheet of [kind], PNG or SVG. */
    data class StillChosen(val kind: FileKind) : ExportEvent

    data object PosterChosen : ExportEvent

    /** Changes what is on the poster. */
    data class PosterChanged(val title: String, val maker: String, val isDated: Boolean) : ExportEvent

    /** Chooses the kind of the poster's file, PNG or SVG. */
    data class PosterKindChosen(val kind: FileKind) : ExportEvent

    /** Saves what was made. */
    data object SaveRequested : ExportEvent

    /** Hands what was made to another app. */
    data object ShareRequested : ExportEvent

    /** Prints the poster that was made. */
    data object PrintRequested : ExportEvent

    /** Cancels what is under way, and returns to the choice. */
    data object BackRequested : ExportEvent

    /** Cancels what is under way, and closes. */
    data object Closed : ExportEvent
}
