package robotran.workshop.event

import robotran.workshop.platform.QrScannerWords
import robotran.workshop.state.HandInOrder
import robotran.workshop.state.HandInRun
import robotran.workshop.state.QrScannerKind

/** An action of the teacher who looks at hand-ins. */
sealed interface HandInsEvent : SchoolEvent {
    /** Opens the hand-ins for the open project, or returns to those that a replay was opened from. */
    data object Requested : HandInsEvent

    /** Closes the page. The hand-ins stay on this device. */
    data object Closed : HandInsEvent

    /** Lets the teacher choose files and zips. */
    data object FilesRequested : HandInsEvent

    data object PastingRequested : HandInsEvent

    /** Brings in the links in [text], whatever stands between them. */
    data class LinksPasted(val text: String) : HandInsEvent

    /** Scans QR codes with hand-ins, see [robotran.workshop.platform.QrScanner]; [words] are for its view. */
    data class ScanRequested(val kind: QrScannerKind, val words: QrScannerWords) : HandInsEvent

    /** Closes the scanner's view. */
    data object ScanEnded : HandInsEvent

    data class OrderChosen(val order: HandInOrder) : HandInsEvent

    /** Stops grading; what is graded stays. */
    data object GradingCancelled : HandInsEvent

    /** Goes on after [GradingCancelled]. */
    data object GradingResumed : HandInsEvent

    /** Opens the hand-in [id]; null returns to the table. */
    data class HandInChosen(val id: String?) : HandInsEvent

    /** Puts the hand-in [other], or the solution if it is empty, beside the open one; null takes it away. */
    data class ComparisonChosen(val other: String?) : HandInsEvent

    /** Shows what can be put beside the open hand-in. */
    data object ComparisonsRequested : HandInsEvent

    /** Changes the comment for the pupil of the hand-in [id]. */
    data class CommentChanged(val id: String, val comment: String) : HandInsEvent

    /** Opens the hand-in [id] in the workshop and runs it: as graded in [run], or with the pupil's inputs for null. */
    data class ReplayRequested(val id: String, val run: HandInRun?) : HandInsEvent

    data object CsvRequested : HandInsEvent

    /** Saves one HTML page with all results. */
    data object PageRequested : HandInsEvent

    /** Saves a zip with a feedback file for each pupil. */
    data object FeedbackRequested : HandInsEvent

    /** Saves the feedback file for the hand-in [id]. */
    data class FeedbackFileRequested(val id: String) : HandInsEvent

    /** Removes the hand-in [id] from the table and from all exports. */
    data class HandInRemoved(val id: String) : HandInsEvent

    /** Takes back the last [HandInRemoved], as long as the page tells of it. */
    data object RemovalUndone : HandInsEvent

    /** Asks whether to remove all hand-ins and comments from this device. */
    data object RemovalRequested : HandInsEvent

    data object RemovalConfirmed : HandInsEvent

    data object DialogClosed : HandInsEvent

    /** Takes away what [robotran.workshop.state.HandInsState.message] says. */
    data object MessageDismissed : HandInsEvent
}
