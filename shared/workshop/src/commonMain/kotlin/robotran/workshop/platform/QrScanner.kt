package robotran.workshop.platform

import robotran.workshop.state.QrScannerKind

/** Reads QR codes: with the camera, or in pictures. */
interface QrScanner {
    /** The ways that there are on this device, the best first. */
    val kinds: List<QrScannerKind>

    /**
     * Lets the user show QR codes until the user ends it. Cancelling the coroutine closes its view.
     *
     * @param kind one of [kinds].
     * @param words what its view says.
     * @param onFound is called with each text once, and returns whether it was of use.
     */
    suspend fun scan(kind: QrScannerKind, words: QrScannerWords, onFound: (String) -> Boolean): QrScanResult
}

/**
 * What the view of a scanner says.
 *
 * @property title what the user does here.
 * @property hint how.
 * @property starting while the camera is switched on.
 * @property counted with `%1$d` in place of the number of useful codes so far.
 * @property useless about a code that is of no use.
 * @property done on the button that ends it.
 */
data class QrScannerWords(
    val title: String,
    val hint: String,
    val starting: String,
    val counted: String,
    val useless: String,
    val done: String,
)

sealed interface QrScanResult {
    /** The user has ended it. */
    data object Ended : QrScanResult

    /** There is no code in the pictures. */
    data object NoCodes : QrScanResult

    /** The user, the browser or the school does not allow the camera. */
    data object NotAllowed : QrScanResult

    /** There is no camera, or another program has it. */
    data object NoCamera : QrScanResult

    /** Anything else; [reason] is the platform's message. */
    data class Failed(val reason: String) : QrScanResult
}
