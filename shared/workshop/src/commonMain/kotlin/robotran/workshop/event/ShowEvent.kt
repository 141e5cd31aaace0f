package robotran.workshop.event

import robotran.workshop.platform.FileKind
import robotran.workshop.state.MovingKind
import robotran.workshop.state.ShowSpeed

/** A user action while showing what was made. */
sealed interface ShowEvent : WorkshopEvent {
    /** Opens the choice of what to make. */
    data object Requested : ShowEvent

    /** Chooses a moving picture of the run. */
    data class MovingChosen(val kind: MovingKind) : ShowEvent

    data class SpeedChosen(val speed: ShowSpeed) : ShowEvent

    /** Makes the moving picture that was chosen. */
    data object MakingRequested : ShowEvent

    /** Saves the sheet as a picture of [kind], PNG or SVG. */
    data class StillChosen(val kind: FileKind) : ShowEvent

    data object PosterChosen : ShowEvent

    /** Changes what is on the poster. */
    data class PosterChanged(val title: String, val maker: String, val isDated: Boolean) : ShowEvent

    data object PosterPrinted : ShowEvent

    data object PosterSaved : ShowEvent

    /** Cancels what is under way, and returns to the choice. */
    data object BackRequested : ShowEvent

    /** Cancels what is under way, and closes. */
    data object Closed : ShowEvent
}
