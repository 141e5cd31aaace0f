package robotran.workshop.handins

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch
import robotran.projects.isLink
import robotran.workshop.platform.QrScanResult
import robotran.workshop.platform.QrScanner
import robotran.workshop.platform.QrScannerWords
import robotran.workshop.state.HandInsMessage
import robotran.workshop.state.HandInsState
import robotran.workshop.state.QrScannerKind

/**
 * Scans QR codes with links to hand-ins.
 *
 * @param scanner null if the platform has none.
 * @param show changes the page.
 * @param onLink is called with each link.
 */
internal class HandInScan(
    private val scanner: QrScanner?,
    private val scope: CoroutineScope,
    private val show: (HandInsState.() -> HandInsState) -> Unit,
    private val onLink: (String) -> Unit,
) {
    private var job: Job? = null

    val kinds: List<QrScannerKind> get() = scanner?.kinds.orEmpty()

    /** Opens the view of the scanner, in place of one that is open. */
    fun begin(kind: QrScannerKind, words: QrScannerWords) {
        val scanner = scanner ?: return
        job?.cancel()
        show { copy(isScanning = true) }
        job = scope.launch {
            val result = scanner.scan(kind, words) { text -> isLink(text).also { if (it) onLink(text) } }
            val message = messageFor(result, kind)
            show { copy(isScanning = false, message = message ?: this.message) }
        }
    }

    /** Closes the view of the scanner. */
    fun end() {
        job?.cancel()
        show { copy(isScanning = false) }
    }
}

/** Null if there is nothing more to say. */
private fun messageFor(result: QrScanResult, kind: QrScannerKind): HandInsMessage? = when (result) {
    QrScanResult.Ended -> null
    QrScanResult.NoCodes -> HandInsMessage.NoCodes(isPhoto = kind == QrScannerKind.PHOTO)
    QrScanResult.NotAllowed -> HandInsMessage.CameraNotAllowed
    QrScanResult.NoCamera -> HandInsMessage.NoCamera
    is QrScanResult.Failed -> HandInsMessage.Unreadable(result.reason)
}
